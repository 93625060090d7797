#pragma once

#include "host/art/geometry/cubic_piece.hpp"

namespace kfast::art {

/// The least squares of a cubic whose ends are given.
class CubicFit {
public:
    CubicFit(scene::Spot from, scene::Spot to) : from_{from}, to_{to} {}

    /// What is to be near `spot` at a parameter from 0 to 1.
    void take(double parameter, scene::Spot spot, double weight);

    /// With any handles.
    CubicPiece free() const;
    /// With handles in given directions, which are not 0.
    CubicPiece along(scene::Spot first, scene::Spot last) const;

private:
    scene::Spot from_;
    scene::Spot to_;
    double first_ = 0;
    double both_ = 0;
    double last_ = 0;
    scene::Spot towards_first_;
    scene::Spot towards_last_;
};

}
