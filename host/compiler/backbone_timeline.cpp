#include "host/compiler/backbone_timeline.hpp"

#include "core/key_interval.hpp"
#include "host/compiler/pack_drawing.hpp"

namespace kfast {
namespace {

scene::Stroke line_through(const std::vector<scene::Point>& points)
{
    scene::Stroke stroke{.from = points.front(), .segments = {}};
    for (std::size_t i = 1; i < points.size(); ++i)
        stroke.segments.push_back({.cubic = false, .c1 = {}, .c2 = {}, .to = points[i]});
    return stroke;
}

/// Where a key is among others.
struct KeyPlace {
    Time time;
    std::size_t index = 0;
};

class KeyPlaceCursor {
public:
    explicit KeyPlaceCursor(const std::vector<scene::BackboneKey>& keys) : keys_{&keys} {}

    bool at_end() const { return next_ == keys_->size(); }
    KeyPlace next()
    {
        const std::size_t index = next_++;
        return {(*keys_)[index].time, index};
    }

private:
    const std::vector<scene::BackboneKey>* keys_;
    std::size_t next_ = 0;
};

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

LiveBackbones BackboneTimeline::at(Time time, std::uint32_t unit_bits, std::span<BackboneNode> nodes) const
{
    const auto [from, to] = interval_at(KeyPlaceCursor{keys_}, time);
    const Progress way = progress_between(from.time, to.time, time, keys_[from.index].laws);
    return {nodes, unit_bits, drawing(from.index), drawing(to.index), way};
}

std::vector<BackboneNode> BackboneTimeline::nodes_at(Time time) const
{
    constexpr std::uint32_t any_unit = 4;
    std::vector<BackboneNode> nodes(node_count());
    at(time, any_unit, nodes);
    return nodes;
}

PackedDrawing BackboneTimeline::drawing(std::size_t index) const
{
    return PackedDrawing{ByteReader{drawings_[index]}};
}

}
