#pragma once

#include "core/beam/beam_point.hpp"

#include <cstdint>

namespace kfast {

/// A straight piece of a line.
class LineInterpolator {
public:
    /// Another one, of a length that is not 0. (Small processors call a function to copy one.)
    void begin(FieldPoint from, FieldVector delta, std::uint32_t length);

    /// At a distance, at most its length, from its beginning; rounded to nearest but for 1/4 unit.
    FieldPoint at(std::uint32_t distance) const;

private:
    /// Of one coordinate, by how much it grows along the piece: in 1/2^14, and 1/2^28 more.
    struct Slope {
        std::uint32_t coarse = 0; ///< at most 1
        std::uint32_t fine = 0;
        bool falls = false;

        void begin(std::int32_t rise, std::uint32_t length);
        std::int32_t operator()(std::uint32_t distance) const;
    };

    FieldPoint from_;
    Slope x_;
    Slope y_;
};

/// Distances that divide a way into equal steps, rounded to nearest.
class BeamSteps {
public:
    BeamSteps() = default;
    /// `count` is at least 1.
    BeamSteps(std::uint32_t length, std::uint32_t count)
        : count_{count}, step_{length / count}, rest_{length - count * step_}, error_{count / 2}
    {
    }

    /// From the beginning.
    std::uint32_t next()
    {
        at_ += step_;
        error_ += rest_;
        if (error_ >= count_) {
            error_ -= count_;
            ++at_;
        }
        return at_;
    }

private:
    std::uint32_t count_ = 1;
    std::uint32_t step_ = 0;
    std::uint32_t rest_ = 0;
    std::uint32_t error_ = 0; ///< of the distance, in 1 / count, and a half
    std::uint32_t at_ = 0;
};

}
