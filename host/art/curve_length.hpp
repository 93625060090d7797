#pragma once

#include "host/scene/outline.hpp"

#include <array>
#include <cstddef>

namespace kfast::art {

/// How far one has gone along a curve: the lengths of the chords of 64 equal steps of its parameter, so that
/// a length is short by less than a thousandth of it unless the curve has a cusp.
class CurveLength {
public:
    CurveLength(scene::Spot from, const scene::Curve& curve);

    double whole() const { return lengths_.back(); }
    /// The parameter, 0 to 1, at that length; lengths beyond the ends are those of the ends.
    double parameter_at(double length) const;

private:
    static constexpr std::size_t steps = 64;
    std::array<double, steps + 1> lengths_{};
};

scene::Spot spot_at(scene::Spot from, const scene::Curve& curve, double parameter);

/// A stretch of a curve between two parameters, `begin` being at most `end`.
struct CurvePiece {
    scene::Spot from;
    scene::Curve curve;
};
CurvePiece piece(scene::Spot from, const scene::Curve& curve, double begin, double end);

}
