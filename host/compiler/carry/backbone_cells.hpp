#pragma once

#include "host/compiler/carry/backbone_cell.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace kfast {

/// A point in relative coordinates (docs/format.md, "Backbones"), a segment of a backbone being 1 long and
/// its outline 1 away, to the right −1.
struct RelativePoint {
    double along = 0;
    double across = 0;
    std::int32_t backbone = 0;
    double limit = 0;        ///< along is less: what follows belongs to the next backbone
    double distance = 0;     ///< pixels that lie between the point and its cell; 0 in the cell
    bool is_deformed = true; ///< false if it has no place there and was moved to the nearest
};

/// The cells of all backbones at one moment.
class BackboneCells {
public:
    explicit BackboneCells(std::span<const BackboneNode> nodes);

    /// Where `spot` is: in the first of the cells that contain it, of those of `preferred` if there are such;
    /// else in the nearest cell that reaches as far.
    RelativePoint place_of(Vec2 spot, std::optional<std::int32_t> preferred = std::nullopt) const;
    /// Likewise, but in a cell of `backbone` in any case.
    RelativePoint place_on(Vec2 spot, std::int32_t backbone) const;
    /// The backbone in whose cells most of `spots` lie, the first of equals.
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
