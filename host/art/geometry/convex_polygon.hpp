#pragma once

#include "host/art/geometry/drawing.hpp"

#include <optional>
#include <span>
#include <vector>

namespace kfast::art {

/// Cuts what is filled. Its sides count as inside, 1/1000 px broad.
class ConvexPolygon {
public:
    /// Nothing if the drawing is not one outline of lines alone that turn in one direction all round.
    static std::optional<ConvexPolygon> of(const Drawing& drawing);

    const std::vector<scene::Vec2>& corners() const { return corners_; }

    /// Whether all that is within `distance` of the points is inside; whether all of it, and what is between
    /// the points, is outside. False if that is not known.
    bool contains(std::span<const scene::Vec2> points, double distance) const;
    bool misses(std::span<const scene::Vec2> points, double distance) const;

    /// The part of a filled drawing that is inside, by either fill rule. Curves are divided where they cross
    /// the polygon; what was outside runs along its sides.
    Drawing cut(const Drawing& drawing) const;

private:
    /// A line, and which side of it is kept.
    struct Side {
        scene::Vec2 on;
        scene::Vec2 inward; ///< of length 1

        double depth(scene::Vec2 spot) const;
    };
    class Cut;

    explicit ConvexPolygon(std::vector<scene::Vec2> corners);
    static std::optional<scene::Outline> cut(const scene::Outline& outline, const Side& side);

    std::vector<scene::Vec2> corners_;
    std::vector<Side> sides_;
};

}
