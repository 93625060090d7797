#pragma once

#include "host/art/geometry/cubic_piece.hpp"

namespace kfast::art {

/// The least squares of a cubic whose ends are given.
class CubicFit {
public:
    CubicFit(scene::Vec2 from, scene::Vec2 to) : from_{from}, to_{to} {}

    /// What is to be near `spot` at a parameter from 0 to 1.
    void take(double parameter, scene::Vec2 spot, double weight);

    /// With any handles.
    CubicPiece free() const;
    /// With handles in given directions, which are not 0.
    CubicPiece along(scene::Vec2 first, scene::Vec2 last) const;

private:
    scene::Vec2 from_;
    scene::Vec2 to_;
    double first_ = 0;
    double both_ = 0;
    double last_ = 0;
    scene::Vec2 towards_first_;
    scene::Vec2 towards_last_;
};

}
