#include "host/compiler/stroke_order.hpp"

#include "core/beam/beam_profile.hpp"
#include "core/beam/beam_route.hpp"
#include "host/compiler/carry/deformed_tweens.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <variant>
#include <vector>

namespace kfast {
namespace {

/// So high that it is hardly ever spent.
constexpr std::uint32_t effort = 20'000'000;

bool is_closed(const scene::Stroke& stroke)
{
    return stroke.segments.size() > 1 && stroke.segments.back().to == stroke.from;
}

scene::Stroke reversed(const scene::Stroke& stroke)
{
    if (stroke.segments.empty())
        return stroke;
    scene::Stroke turned{.from = stroke.segments.back().to, .segments = {}};
    for (std::size_t i = stroke.segments.size(); i-- > 0;) {
        const scene::Segment& segment = stroke.segments[i];
        turned.segments.push_back({.cubic = segment.cubic,
                                   .c1 = segment.c2,
                                   .c2 = segment.c1,
                                   .to = i == 0 ? stroke.from : stroke.segments[i - 1].to});
    }
    return turned;
}

/// A closed stroke that begins after that many of its segments.
scene::Stroke begun_at(scene::Stroke stroke, std::size_t segments)
{
    if (segments == 0)
        return stroke;
    stroke.from = stroke.segments[segments - 1].to;
    std::rotate(stroke.segments.begin(), stroke.segments.begin() + static_cast<std::ptrdiff_t>(segments),
                stroke.segments.end());
    return stroke;
}

/// The strokes of a drawing as lines in a field with units of 1/16 px.
class StrokeLines {
public:
    explicit StrokeLines(const scene::Drawing& drawing)
        : storage_(5 * drawing.strokes.size() + scene::point_count(drawing) + 4),
          lines_{std::as_writable_bytes(std::span{storage_})}
    {
        for (const scene::Stroke& stroke : drawing.strokes)
            add(stroke);
    }

    const BeamLines& lines() const { return lines_; }
    /// How many segments of a stroke are before a point of its line.
    std::size_t segments_before(const BeamLeg& leg) const { return starts_[leg.line][leg.start]; }

private:
    /// Adds a stroke; of an open one, its ends alone.
    void add(const scene::Stroke& stroke)
    {
        starts_.emplace_back();
        lines_.begin({}, 0);
        add(stroke.from, 0);
        for (std::size_t i = 0; i < stroke.segments.size(); ++i)
            if (is_closed(stroke) || i + 1 == stroke.segments.size())
                add(stroke.segments[i].to, i + 1);
        lines_.end();
    }

    void add(scene::Point point, std::size_t segments_before)
    {
        const std::uint32_t known = lines_.open_points();
        lines_.add({point.x, point.y});
        if (lines_.open_points() != known)
            starts_.back().push_back(segments_before);
    }

    std::vector<std::uint32_t> storage_;
    BeamLines lines_;
    std::vector<std::vector<std::size_t>> starts_; ///< of each point of each line
};

/// The route with the longest travel after the last leg.
std::vector<BeamLeg> route_of(const BeamLines& lines)
{
    std::vector<BeamLeg> legs(lines.size());
    find_route(lines, {}, legs, effort);
    const auto travel_to = [&](std::size_t place) {
        const BeamLeg& before = legs[(place == 0 ? legs.size() : place) - 1];
        return beam_travel(end_of(lines, before), begin_of(lines, legs[place]));
    };
    std::size_t first = 0;
    for (std::size_t place = 1; place < legs.size(); ++place)
        if (travel_to(place) > travel_to(first))
            first = place;
    std::rotate(legs.begin(), legs.begin() + static_cast<std::ptrdiff_t>(first), legs.end());
    return legs;
}

/// BeamLines holds no more points.
bool is_small(const scene::Drawing& drawing)
{
    return drawing.strokes.size() > 1 && scene::point_count(drawing) < BeamLines::max_points;
}

/// The depths of a wire frame have to stay in step with its strokes, and an order that is short as they are
/// drawn is not when they are rotated.
bool never_changes(const scene::Object& object)
{
    return object.keys.size() == 1 && deformer_of(object) == Deformer::none && !object.has_depths &&
           object.stroke && !object.fill;
}

void order_strokes_of(std::vector<scene::Item>& items)
{
    for (scene::Item& item : items)
        if (auto* const group = std::get_if<scene::Group>(&item.content))
            order_strokes_of(group->items);
        else if (auto* const object = std::get_if<scene::Object>(&item.content);
                 object != nullptr && never_changes(*object))
            order_strokes(object->keys.front().drawing);
}

}

void order_strokes(scene::Drawing& drawing)
{
    if (!is_small(drawing))
        return;
    const StrokeLines strokes{drawing};
    scene::Drawing ordered;
    for (const BeamLeg& leg : route_of(strokes.lines())) {
        scene::Stroke& stroke = drawing.strokes[leg.line];
        ordered.strokes.push_back(
            leg.is_reversed ? reversed(stroke) : begun_at(std::move(stroke), strokes.segments_before(leg)));
    }
    drawing = std::move(ordered);
}

void order_strokes(scene::Scene& scene)
{
    for (scene::Symbol& symbol : scene.symbols)
        order_strokes_of(symbol.items);
    order_strokes_of(scene.items);
}

}
