#pragma once

#include "core/beam/beam_profile.hpp"
#include "core/pixel/paint_style.hpp"

#include <cstdint>

namespace kfast {

/// How far a beam goes from point to point, and how long it waits, at a speed level. Four levels more are
/// twice as fast.
class StepProfile {
public:
    /// The highest level: every line is crossed at once.
    static constexpr int max_speed_level = 4 * 31;
    /// Where speed represents light, darker lines are drawn as if they were as bright as this, so that the
    /// beam is no more than 8 times as fast as along the brightest.
    static constexpr std::uint32_t darkest = 32;
    /// How long a dot is lit besides its dwell, in points, so that it is as bright as a line.
    static constexpr std::uint32_t dot_points = 4;

    /// `profile` must outlive it.
    StepProfile(const BeamProfile& profile, int speed_level) : profile_{&profile}, speed_level_{speed_level}
    {
    }

    /// The lit step in units of the field, at least 1.
    std::uint32_t lit_step(Colour colour) const;
    /// The blanked step in units of the field; 0 if the beam jumps.
    std::uint32_t travel_step() const;
    /// The rest of a time in points.
    std::uint32_t dwell(std::uint32_t points) const { return points >> (speed_level_ >> 2); }
    /// The time that a dot is lit, at least 1.
    std::uint32_t dot_dwell(Colour colour) const;
    /// Whether corners are points. At very high speed levels they are cut off.
    bool hits_corners() const { return speed_level_ < 4 * 3; }
    const BeamProfile& profile() const { return *profile_; }

private:
    std::uint32_t scaled_step(std::uint32_t step) const;

    const BeamProfile* profile_;
    int speed_level_;
};

/// A straight piece of a line.
class LineInterpolator {
public:
    /// Begins another piece, of a length that is not 0. (Small processors call a function to copy one.)
    void begin(FieldPoint from, FieldVector delta, std::uint32_t length);

    /// The point at a distance, at most its length, from its beginning; rounded to nearest but for 1/4 unit.
    FieldPoint at(std::uint32_t distance) const;

private:
    /// By how much a coordinate increases along the piece: in 1/2^14, and 1/2^28 more.
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

/// Distances that divide a length into equal steps, rounded to nearest.
class BeamSteps {
public:
    BeamSteps() = default;
    /// `count` is at least 1.
    BeamSteps(std::uint32_t length, std::uint32_t count)
        : count_{count}, step_{length / count}, rest_{length - count * step_}, error_{count / 2}
    {
    }

    /// The distance from the beginning.
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

/// The direction of a straight piece.
class BeamDirection {
public:
    /// Shorter pieces have none: their corners are rounded.
    static constexpr std::uint32_t shortest = 8;

    BeamDirection() = default;
    BeamDirection(FieldVector piece, std::uint32_t length);

    bool is_known() const { return length_ != 0; }

private:
    friend class BeamTurn;

    std::int32_t x_ = 0; ///< so that the products of two, added up, fit in 32 bits
    std::int32_t y_ = 0;
    std::uint32_t length_ = 0;
};

/// How sharply a line changes direction between two pieces: (1 - cos) / 2 of the angle, 0 … 1.
class BeamTurn {
public:
    /// No turn if one of them is not known.
    BeamTurn(const BeamDirection& before, const BeamDirection& after);

    /// Whether the angle is 29° (the cosine is 7/8) or more. A smaller one is taken for a curve.
    bool is_corner() const { return rest_ > whole_ >> 3; }
    /// The fraction of `max`, at most 255, rounded to nearest; none where there is no corner.
    std::uint32_t share_of(std::uint32_t max) const;

private:
    std::uint32_t whole_ = 0; ///< the product of the lengths
    std::uint32_t rest_ = 0;  ///< (1 - cos) times that
};

}
