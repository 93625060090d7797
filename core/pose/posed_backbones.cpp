#include "core/pose/posed_backbones.hpp"

#include "core/bytes/function_ref.hpp"
#include "core/bytes/op_counter.hpp"
#include "core/math/point.hpp"

#include <algorithm>
#include <cstdlib>

namespace kfast {
namespace {

constexpr std::int32_t one_px = Fixed::one;
constexpr std::int32_t max_across = 8 * one_px; ///< Q16, across
/// A point along a cell whose points are within small_reach, or as far again beyond either end of it, is
/// within three times that, and within nine times if it is up to small_width across: that fits in Fixed.
constexpr std::int32_t small_reach = 1023 * one_px;
constexpr std::int32_t small_width = 2 * one_px;

/// The fraction `share` is in Q16 and may be beyond 0 … 1.
std::int64_t mix(std::int64_t a, std::int64_t b, std::int32_t share)
{
    return a + rounded_shift((b - a) * share, 16);
}

/// The same bits, where all of it fits in 32 bits.
std::int32_t mix(std::int32_t a, std::int32_t b, std::int32_t share)
{
    return a + multiply_q16(b - a, share);
}

/// Interpolates from the line between two nodes to that between their outline points.
template <class Number>
Point placed_across(const BackboneNode& a, const BackboneNode& b, Point BackboneNode::*side,
                    std::int32_t along, std::int32_t width)
{
    const auto placed = [=, &a, &b](Fixed Point::*axis) {
        const auto mixed = [=, &a, &b](Point BackboneNode::*line) {
            return mix(Number{(a.*line.*axis).raw()}, Number{(b.*line.*axis).raw()}, along);
        };
        return mix(mixed(&BackboneNode::middle), mixed(side), width);
    };
    return clamped_point(placed(&Point::x), placed(&Point::y), max_tweened_coordinate);
}

bool is_small(Point point)
{
    return std::abs(point.x.raw()) <= small_reach && std::abs(point.y.raw()) <= small_reach;
}

}

PosedBackbones::PosedBackbones(std::span<BackboneNode> nodes, std::uint32_t unit_bits, PackedDrawing from,
                               PackedDrawing to, ProgressXY progress)
    : between_{plain_function<&PosedBackbones::between_points>}, nodes_{nodes}, unit_bits_{unit_bits}
{
    const auto next_stroke = [&from, &to] {
        to.next_stroke();
        return from.next_stroke();
    };
    const auto next_point = [&](bool is_first) {
        const Point a = is_first ? from.start() : from.next_segment().to;
        return lerp(a, is_first ? to.start() : to.next_segment().to, progress.x, progress.y);
    };
    take(from.strokes(), next_stroke, next_point);
}

PosedBackbones::PosedBackbones(std::span<BackboneNode> nodes, std::uint32_t unit_bits, TweenReader both,
                               ProgressXY progress)
    : between_{plain_function<&PosedBackbones::between_points>}, nodes_{nodes}, unit_bits_{unit_bits}
{
    const auto next_stroke = [&both] { return both.next_stroke(); };
    const auto next_point = [&](bool is_first) {
        if (!is_first)
            both.is_next_cubic(); // they are lines
        return both.next_point(progress);
    };
    take(both.strokes(), next_stroke, next_point);
}

/// Takes three strokes for each backbone, and adds a gap after it.
/// `is_first` of next_point(is_first) says whether it is the first point of a stroke.
void PosedBackbones::take(std::uint32_t strokes, FunctionRef<std::uint32_t()> next_stroke,
                          FunctionRef<Point(bool)> next_point)
{
    std::size_t first = 0;
    const auto count = static_cast<std::int32_t>(strokes / 3);
    for (std::int32_t backbone = 0; backbone < count; ++backbone) {
        std::size_t behind = first;
        for (const auto side : {&BackboneNode::middle, &BackboneNode::left, &BackboneNode::right}) {
            behind = first + next_stroke() + 1;
            for (std::size_t node = first; node != behind; ++node) {
                const Point at = next_point(node == first);
                nodes_[node].*side = at;
                nodes_[node].backbone = backbone;
                are_small_ = are_small_ && is_small(at);
            }
        }
        nodes_[behind].backbone = -1;
        first = behind + 1;
    }
    nodes_ = nodes_.first(first);
    is_one_ = count == 1;
}

Point PosedBackbones::place(Point relative) const { return place(cell_at(relative.x), relative.y); }

Point PosedBackbones::place(Cell cell, Fixed across) const
{
    const BackboneNode& a = nodes_[static_cast<std::size_t>(cell.node)];
    const BackboneNode& b = nodes_[static_cast<std::size_t>(cell.node) + 1];
    const auto side = across >= Fixed{} ? &BackboneNode::left : &BackboneNode::right;
    const std::int32_t size = across >= Fixed{} ? across.raw() : -across.raw();
    const std::int32_t width = std::min(size >> (unit_bits_ - 4), max_across);
    if (are_small_ && width <= small_width)
        return placed_across<std::int32_t>(a, b, side, cell.along, width);
    return placed_across<std::int64_t>(a, b, side, cell.along, width);
}

Point PosedBackbones::between_points(Point a, Point b, ProgressXY progress) const
{
    count_op(Op::bent_point);
    if (a == b)
        return place(a);
    const Point at = lerp(a, b, progress.x, progress.y);
    if (is_one_)
        return place(at);
    const std::int32_t backbone = backbone_of(cell_at(a.x));
    if (backbone != backbone_of(cell_at(b.x)))
        return lerp(place(a), place(b), progress.x, progress.y);
    const Cell cell = cell_at(at.x);
    const std::int32_t reached = backbone_of(cell);
    return place(reached == backbone ? cell : end_of(backbone, reached < backbone), at.y);
}

PosedBackbones::Cell PosedBackbones::cell_at(Fixed along) const
{
    const std::int32_t node = along.raw() >> (unit_bits_ + 12);
    const std::int32_t share = (along.raw() & ((1 << (unit_bits_ + 12)) - 1)) >> (unit_bits_ - 4);
    if (is_node(node))
        return is_node(node + 1) ? Cell{node, share} : Cell{node - 1, one_px + share};
    if (is_node(node + 1))
        return {node + 1, share - one_px};
    if (node < 0)
        return {0, -one_px};
    return {static_cast<std::int32_t>(nodes_.size()) - 3, 2 * one_px};
}

/// The outermost cell that belongs to the backbone.
PosedBackbones::Cell PosedBackbones::end_of(std::int32_t backbone, bool is_beginning) const
{
    std::int32_t node = 0;
    while (nodes_[static_cast<std::size_t>(node)].backbone != backbone)
        ++node;
    if (is_beginning)
        return {node, -one_px};
    while (is_node(node + 2))
        ++node;
    return {node, 2 * one_px};
}

bool PosedBackbones::is_node(std::int32_t index) const
{
    return index >= 0 && static_cast<std::size_t>(index) < nodes_.size() &&
           nodes_[static_cast<std::size_t>(index)].backbone >= 0;
}

}
