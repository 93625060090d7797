#pragma once

#include "host/geometry/outline.hpp"

#include <vector>

namespace kfast::scene {

/// A place on a path, and the unit vector along it there.
struct PathPlace {
    Vec2 spot;
    Vec2 direction;
};

/// Measures lengths along a stroke, whose curves it takes for 256 chords each.
class PathRuler {
public:
    /// `outline` has an extent.
    explicit PathRuler(const Outline& outline);

    /// Pixels.
    double length() const { return distances_.back(); }
    bool is_closed() const { return is_closed_; }
    /// What lies `distance` pixels behind the beginning. Beyond its ends a path goes straight on, or, if it
    /// is closed, round again.
    PathPlace at(double distance) const;

private:
    void add(Vec2 corner);

    std::vector<Vec2> corners_;
    std::vector<double> distances_; ///< of each corner from the beginning
    bool is_closed_;
};

}
