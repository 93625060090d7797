#pragma once

#include "core/pose/posed_backbones.hpp"
#include "host/geometry/outline.hpp"

#include <optional>

namespace kfast {

using scene::Vec2;

Vec2 in_pixels(Point point);

/// Where a point is in a cell, in shares of it: along the backbone, and away from it.
struct CellPlace {
    double along = 0;
    double across = 0;
};

/// What lies between two nodes of a backbone and their outline points on one side.
///
/// Only operations that every machine rounds alike are used, so that a scene compiles to the same bytes
/// everywhere.
class BackboneCell {
public:
    /// `side` is left or right. Along the backbone, the cell reaches from `first` to `last`: 0 … 1, further
    /// where it is the first or the last one.
    BackboneCell(const BackboneNode& a, const BackboneNode& b, Point BackboneNode::*side, double first,
                 double last);

    Vec2 spot_at(CellPlace place) const;
    /// Where `spot` is, if that is within what the cell reaches to: the backbone on one hand, and as far as
    /// the format goes on the other.
    std::optional<CellPlace> place_of(Vec2 spot) const;
    /// Of the points of the quadrilateral, the nearest to `spot`.
    CellPlace nearest(Vec2 spot) const;
    /// False for sure where `spot` is not inside of the box around the quadrilateral.
    bool may_contain(Vec2 spot) const;

private:
    std::optional<CellPlace> place_at(Vec2 from_corner, double across) const;

    Vec2 corner_; ///< the first node
    Vec2 along_;  ///< from there to the next node
    Vec2 across_; ///< from there to the outline
    Vec2 twist_;  ///< how the latter changes along the cell
    Vec2 low_;    ///< of the box around the quadrilateral
    Vec2 high_;
    double first_;
    double last_;
};

/// In the quadrilateral itself.
bool is_inside(CellPlace place);

}
