#include "core/live_backbones.hpp"

#include "core/held_point.hpp"
#include "core/work.hpp"

#include <algorithm>

namespace kfast {
namespace {

constexpr std::int32_t one = Fixed::one;
constexpr std::int32_t widest = 8 * one; ///< Q16, across

/// `share` is in Q16 and may lie beyond 0 … 1.
std::int64_t mix(std::int64_t a, std::int64_t b, std::int32_t share)
{
    return a + (((b - a) * share + one / 2) >> 16);
}

/// From the line between two nodes towards that between their outline points.
template <Fixed Point::*axis>
std::int64_t point_across(const BackboneNode& a, const BackboneNode& b, Point BackboneNode::*side,
                          std::int32_t along, std::int32_t width)
{
    const std::int64_t middle = mix((a.middle.*axis).raw(), (b.middle.*axis).raw(), along);
    const std::int64_t outline = mix((a.*side.*axis).raw(), (b.*side.*axis).raw(), along);
    return mix(middle, outline, width);
}

}

std::size_t backbone_node_count(PackedDrawing drawing)
{
    std::size_t count = 0;
    for (std::uint32_t stroke = 0; stroke < drawing.strokes(); ++stroke) {
        const std::uint32_t segments = drawing.next_stroke();
        if (stroke % 3 == 0)
            count += segments + 2;
        for (std::uint32_t i = 0; i < segments; ++i)
            drawing.next_segment();
    }
    return count;
}

LiveBackbones::LiveBackbones(std::span<BackboneNode> nodes, std::uint32_t unit_bits, PackedDrawing from,
                             PackedDrawing to, Progress way)
    : nodes_{nodes.first(backbone_node_count(from))}, unit_bits_{unit_bits}
{
    std::ranges::fill(nodes_, BackboneNode{});
    std::size_t first = 0;
    const std::uint32_t count = from.strokes() / 3;
    for (std::uint32_t number = 0; number < count; ++number) {
        const auto backbone = static_cast<std::int32_t>(number);
        for (const auto side : {&BackboneNode::middle, &BackboneNode::left, &BackboneNode::right})
            take_stroke(from, to, way, side, first, backbone);
        while (is_node(static_cast<std::int32_t>(first)))
            ++first;
        ++first;
    }
}

void LiveBackbones::take_stroke(PackedDrawing& from, PackedDrawing& to, Progress way,
                                Point BackboneNode::*side, std::size_t first, std::int32_t backbone)
{
    const std::uint32_t segments = from.next_stroke();
    to.next_stroke();
    nodes_[first].*side = lerp(from.start(), to.start(), way.x, way.y);
    nodes_[first].backbone = backbone;
    for (std::uint32_t i = 1; i <= segments; ++i) {
        nodes_[first + i].*side = lerp(from.next_segment().to, to.next_segment().to, way.x, way.y);
        nodes_[first + i].backbone = backbone;
    }
}

Point LiveBackbones::place(Point relative) const { return place(cell_at(relative.x), relative.y); }

Point LiveBackbones::place(Cell cell, Fixed across) const
{
    const BackboneNode& a = nodes_[static_cast<std::size_t>(cell.node)];
    const BackboneNode& b = nodes_[static_cast<std::size_t>(cell.node) + 1];
    const auto side = across >= Fixed{} ? &BackboneNode::left : &BackboneNode::right;
    const std::int32_t size = across >= Fixed{} ? across.raw() : -across.raw();
    const std::int32_t width = std::min(size >> (unit_bits_ - 4), widest);
    return held_point(point_across<&Point::x>(a, b, side, cell.along, width),
                      point_across<&Point::y>(a, b, side, cell.along, width), farthest_tweened);
}

Point LiveBackbones::between(Point a, Point b, Progress way) const
{
    did(Work::bent_point);
    if (a == b)
        return place(a);
    const std::int32_t backbone = backbone_of(cell_at(a.x));
    if (backbone != backbone_of(cell_at(b.x)))
        return lerp(place(a), place(b), way.x, way.y);
    const Point at = lerp(a, b, way.x, way.y);
    const Cell cell = cell_at(at.x);
    const std::int32_t reached = backbone_of(cell);
    return place(reached == backbone ? cell : end_of(backbone, reached < backbone), at.y);
}

Segment LiveBackbones::between(const Segment& a, const Segment& b, Progress way) const
{
    if (a.kind == Segment::Kind::line && b.kind == Segment::Kind::line)
        return {.from = between(a.from, b.from, way), .to = between(a.to, b.to, way)};
    const Segment from = as_cubic(a);
    const Segment to = as_cubic(b);
    return {Segment::Kind::cubic, between(from.from, to.from, way), between(from.c1, to.c1, way),
            between(from.c2, to.c2, way), between(from.to, to.to, way)};
}

LiveBackbones::Cell LiveBackbones::cell_at(Fixed along) const
{
    const std::int32_t node = along.raw() >> (unit_bits_ + 12);
    const std::int32_t share = (along.raw() & ((1 << (unit_bits_ + 12)) - 1)) >> (unit_bits_ - 4);
    if (is_node(node))
        return is_node(node + 1) ? Cell{node, share} : Cell{node - 1, one + share};
    if (is_node(node + 1))
        return {node + 1, share - one};
    if (node < 0)
        return {0, -one};
    return {static_cast<std::int32_t>(nodes_.size()) - 3, 2 * one};
}

/// As far out as belongs to the backbone.
LiveBackbones::Cell LiveBackbones::end_of(std::int32_t backbone, bool is_beginning) const
{
    std::int32_t node = 0;
    while (nodes_[static_cast<std::size_t>(node)].backbone != backbone)
        ++node;
    if (is_beginning)
        return {node, -one};
    while (is_node(node + 2))
        ++node;
    return {node, 2 * one};
}

bool LiveBackbones::is_node(std::int32_t index) const
{
    return index >= 0 && static_cast<std::size_t>(index) < nodes_.size() &&
           nodes_[static_cast<std::size_t>(index)].backbone >= 0;
}

}
