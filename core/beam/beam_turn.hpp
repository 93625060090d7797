#pragma once

#include "core/beam/beam_point.hpp"

#include <cstdint>

namespace kfast {

/// Which way a straight piece runs.
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

/// How sharply a line turns from one piece to the next: by (1 - cos) / 2 of the angle, 0 … 1.
class BeamTurn {
public:
    /// None if one of them is not known.
    BeamTurn(const BeamDirection& before, const BeamDirection& after);

    /// By 29° (the cosine is 7/8) or more. What turns by less is taken for a curve.
    bool is_corner() const { return rest_ > whole_ >> 3; }
    /// The share of `max`, at most 255, rounded to nearest; none where there is no corner.
    std::uint32_t share_of(std::uint32_t max) const;

private:
    std::uint32_t whole_ = 0; ///< the product of the lengths
    std::uint32_t rest_ = 0;  ///< (1 - cos) times that
};

}
