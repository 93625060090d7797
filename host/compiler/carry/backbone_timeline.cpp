#include "host/compiler/carry/backbone_timeline.hpp"

#include "core/features.hpp"
#include "core/time/track.hpp"
#include "host/compiler/pack/pack_drawing.hpp"

#include <algorithm>

namespace kfast {
namespace {

scene::Stroke line_through(const std::vector<scene::Point>& points)
{
    scene::Stroke stroke{.from = points.front(), .segments = {}};
    for (std::size_t i = 1; i < points.size(); ++i)
        stroke.segments.push_back({.cubic = false, .c1 = {}, .c2 = {}, .to = points[i]});
    return stroke;
}

}

scene::Drawing drawing_of(const std::vector<scene::Backbone>& backbones)
{
    scene::Drawing drawing;
    for (const scene::Backbone& backbone : backbones)
        for (const auto* points : {&backbone.nodes, &backbone.left, &backbone.right})
            drawing.strokes.push_back(line_through(*points));
    return drawing;
}

BackboneTimeline::BackboneTimeline(const std::vector<scene::BackboneKey>& keys) : keys_{keys}
{
    for (const scene::BackboneKey& key : keys) {
        ByteWriter packed;
        pack_drawing(drawing_of(key.backbones), packed);
        drawings_.push_back(packed.bytes());
    }
}

std::vector<Time> BackboneTimeline::key_times() const
{
    std::vector<Time> times;
    for (const scene::BackboneKey& key : keys_)
        times.push_back(key.time);
    return times;
}

std::size_t BackboneTimeline::node_count() const { return backbone_node_count(drawing(0)); }

PosedBackbones BackboneTimeline::at(Time time, std::uint32_t unit_bits, std::span<BackboneNode> nodes) const
{
    const auto later = std::ranges::upper_bound(keys_, time, {}, &scene::BackboneKey::time) - keys_.begin();
    const auto next = static_cast<std::size_t>(later);
    const std::size_t from = next == 0 ? 0 : next - 1;
    const std::size_t to = next == 0 || next == keys_.size() ? from : next;
    const ProgressXY progress =
        progress_between(keys_[from].time, keys_[to].time, time, keys_[from].laws, &kfast_springs);
    return {nodes, unit_bits, drawing(from), drawing(to), progress};
}

std::vector<BackboneNode> BackboneTimeline::nodes_at(Time time) const
{
    constexpr std::uint32_t any_unit = 4;
    std::vector<BackboneNode> nodes(node_count());
    at(time, any_unit, nodes);
    return nodes;
}

PackedDrawing BackboneTimeline::drawing(std::size_t index) const { return drawing_at(drawings_[index], 0); }

}
