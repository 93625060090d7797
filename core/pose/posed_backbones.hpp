#pragma once

#include "core/bytes/function_ref.hpp"
#include "core/pose/tween_cache.hpp"
#include "core/scene/packed_drawing.hpp"
#include "core/scene/skeleton_view.hpp"
#include "core/time/track.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// A node of a backbone and the points of its outline, on the canvas; or the gap between two backbones.
struct BackboneNode {
    Point middle;
    Point left;
    Point right;
    std::int32_t backbone = -1; ///< its number; -1 for a gap
};

/// The backbones of an object at one time, and the map from relative coordinates to the canvas.
///
/// A node's place on the axis is its index in the list, so that relative coordinates (docs/format.md,
/// "Backbones") lead to it without a search.
class PosedBackbones {
public:
    /// `nodes` has room for as many as backbone_node_count() says and must outlive this. `from` and `to` are
    /// two drawings of the backbones, which are tweened by `progress`.
    [[gnu::cold, gnu::noinline]] PosedBackbones(std::span<BackboneNode> nodes, std::uint32_t unit_bits,
                                                PackedDrawing from, PackedDrawing to, ProgressXY progress);
    /// The same, with the two drawings as they are kept.
    PosedBackbones(std::span<BackboneNode> nodes, std::uint32_t unit_bits, TweenReader both,
                   ProgressXY progress);

    /// Maps to the canvas, clamped to ±4095 px; rounded to 1/65536 px three times.
    Point place(Point relative) const;
    /// Tweens two points in relative coordinates: in these where both belong to one backbone, which progress
    /// that overshoots far does not leave either; else straight from one mapped point to the other. Within
    /// ±16380 px.
    Point between(Point a, Point b, ProgressXY progress) const { return between_(*this, a, b, progress); }

private:
    Point between_points(Point a, Point b, ProgressXY progress) const;
    /// A segment and a position on it.
    struct Cell {
        std::int32_t node;  ///< the first of two
        std::int32_t along; ///< Q16, 0 … 1, further at the ends of a backbone: -1 … 2
    };

    void take(std::uint32_t strokes, FunctionRef<std::uint32_t()> next_stroke,
              FunctionRef<Point(bool)> next_point);
    Cell cell_at(Fixed along) const;
    Cell end_of(std::int32_t backbone, bool is_beginning) const;
    Point place(Cell cell, Fixed across) const;
    bool is_node(std::int32_t index) const;
    std::int32_t backbone_of(Cell cell) const { return nodes_[static_cast<std::size_t>(cell.node)].backbone; }

    /// The function that works on it: linked only with what makes one.
    Point (*between_)(const PosedBackbones&, Point, Point, ProgressXY);
    std::span<BackboneNode> nodes_;
    std::uint32_t unit_bits_;
    bool is_one_ = false;   ///< there is a single backbone
    bool are_small_ = true; ///< the nodes are where 32 bits are enough for most points
};

}
