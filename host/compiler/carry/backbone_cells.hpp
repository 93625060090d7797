#pragma once

#include "core/pose/posed_backbones.hpp"
#include "host/geometry/outline.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace kfast {

using scene::Vec2;

Vec2 in_pixels(Point point);

/// Where a point is in a cell, in fractions of it: along the backbone, and away from it.
struct CellPlace {
    double along = 0;
    double across = 0;
};

/// The quadrilateral between two nodes of a backbone and their outline points on one side.
///
/// Only operations that every machine rounds identically are used, so that a scene compiles to the same bytes
/// everywhere.
class BackboneCell {
public:
    /// `side` is left or right. Along the backbone, the cell reaches from `first` to `last`: 0 … 1, further
    /// where it is the first or the last one.
    BackboneCell(const BackboneNode& a, const BackboneNode& b, Point BackboneNode::*side, double first,
                 double last);

    Vec2 spot_at(CellPlace place) const;
    /// Where `spot` is, if the cell reaches that far: to the backbone on one side, and as far as the format
    /// goes on the other.
    std::optional<CellPlace> place_of(Vec2 spot) const;
    /// The point of the quadrilateral that is nearest to `spot`.
    CellPlace nearest(Vec2 spot) const;
    /// False if `spot` is outside of the bounding box of the quadrilateral.
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

/// Whether it is in the quadrilateral itself.
bool is_inside(CellPlace place);

/// A point in relative coordinates (docs/format.md, "Backbones"), a segment of a backbone being 1 long and
/// its outline 1 away, to the right −1.
struct RelativePoint {
    double along = 0;
    double across = 0;
    std::int32_t backbone = 0;
    double limit = 0;        ///< along is less: what follows belongs to the next backbone
    double distance = 0;     ///< pixels between the point and its cell; 0 in the cell
    bool is_deformed = true; ///< false if it has no position there and was moved to the nearest
};

/// The cells of all backbones at one time.
class BackboneCells {
public:
    explicit BackboneCells(std::span<const BackboneNode> nodes);

    /// Where `spot` is: in the first of the cells that contain it, of those of `preferred` if there are any;
    /// else in the nearest cell that reaches as far.
    RelativePoint place_of(Vec2 spot, std::optional<std::int32_t> preferred = std::nullopt) const;
    /// The same, but always in a cell of `backbone`.
    RelativePoint place_on(Vec2 spot, std::int32_t backbone) const;
    /// The backbone in whose cells most of `spots` are; the first of equals.
    std::int32_t main_backbone(std::span<const Vec2> spots) const;

    /// Where the nodes of a backbone are, along.
    struct Reach {
        double first_node;
        double last_node;
    };
    Reach reach(std::int32_t backbone) const { return reaches_[static_cast<std::size_t>(backbone)]; }

private:
    struct Cell {
        BackboneCell shape;
        double begin; ///< along
        double sign;  ///< of what is across
        std::int32_t backbone;
    };

    void add_cells(std::span<const BackboneNode> nodes, std::size_t first);
    RelativePoint in_cell(const Cell& cell, CellPlace place) const;

    const Cell* containing(Vec2 spot, std::optional<std::int32_t> backbone) const;
    RelativePoint nearest(Vec2 spot, std::optional<std::int32_t> backbone) const;

    std::vector<Cell> cells_; ///< in the order of the backbones, then of their segments, the left one first
    std::vector<Reach> reaches_;
};

}
