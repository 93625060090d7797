#include "host/scene/items/object_dashes.hpp"

#include "host/geometry/outline.hpp"
#include "host/scene/values/dash_reader.hpp"
#include "host/schema/property_rule.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <string>

namespace kfast::scene {
namespace {

constexpr std::string_view dash_name = "dash";

bool has_dash(const ItemKey& key) { return dash_length_count(key.values) != 0; }

/// Whether `count` lengths repeat to `all` of them.
bool fits(std::size_t count, std::size_t all) { return count == 0 || all % count == 0; }

void warn_of_idle_offset(const kdl::Node& object, const std::vector<ItemKey>& keys, SceneContext& context)
{
    constexpr std::string_view offset = "dash-offset";
    const auto warn = [&](const kdl::Node& node) {
        if (has_property(node, offset))
            context.report.warning(property_span(node, offset), "dash-offset does nothing without dashes",
                                   "add dash=\"8 4\" or remove dash-offset");
    };
    warn(object);
    for (const ItemKey& key : keys)
        warn(*key.node);
}

Vec2 pixels(Point at) { return {at.x / 16.0, at.y / 16.0}; }

Vec2 spot_on(Vec2 from, const Segment& segment, double t)
{
    const double s = 1 - t;
    if (!segment.cubic)
        return s * from + t * pixels(segment.to);
    return s * s * s * from + 3 * s * s * t * pixels(segment.c1) + 3 * s * t * t * pixels(segment.c2) +
           t * t * t * pixels(segment.to);
}

double length_of(const Stroke& stroke)
{
    constexpr int chords = 16;
    double length = 0;
    Vec2 from = pixels(stroke.from);
    for (const Segment& segment : stroke.segments) {
        Vec2 last = from;
        for (int i = 1; i <= chords; ++i) {
            const Vec2 to = spot_on(from, segment, i / double{chords});
            length += distance(last, to);
            last = to;
        }
        from = last;
    }
    return length;
}

/// A pattern in pixels.
struct Pattern {
    double period = std::numeric_limits<double>::infinity();
    double dashes = 0; ///< in each period
};

/// The shortest that keys have, of those that have a length.
Pattern shortest_pattern(const std::vector<Track>& tracks)
{
    std::vector<double> periods;
    Pattern shortest;
    for (const Track& track : tracks) {
        if (!is_dash_length(track.property))
            continue;
        periods.resize(std::max(periods.size(), track.keys.size()));
        const auto index = static_cast<int>(track.property) - static_cast<int>(Property::dash_1);
        shortest.dashes =
            std::max(shortest.dashes, static_cast<double>(index / 2 + 1)); // lengths of 0 may have no track
        for (std::size_t i = 0; i < periods.size(); ++i)
            periods[i] += track.keys[std::min(i, track.keys.size() - 1)].value / double{dash_pixel};
    }
    for (const double period : periods)
        if (period > 0)
            shortest.period = std::min(shortest.period, period);
    return shortest;
}

/// Counts what is cut off at both ends of a stroke as dashes of their own.
double dashes_of(const Drawing& drawing, const Pattern& pattern)
{
    double dashes = 0;
    for (const Stroke& stroke : drawing.strokes)
        dashes += (std::ceil(length_of(stroke) / pattern.period) + 1) * pattern.dashes;
    return dashes;
}

double dashes_of(const std::vector<Key>& keys, const Pattern& pattern)
{
    double most = 0;
    for (const Key& key : keys)
        most = std::max(most, dashes_of(key.drawing, pattern));
    return most;
}

/// Drawings grow between keys and where they are carried; what comes from outside has any length.
std::int32_t limit_for(double dashes, const Object& object)
{
    if (object.live || object.label)
        return max_dash_count;
    const bool is_carried = object.skin || !object.backbone_keys.empty();
    return static_cast<std::int32_t>(
        std::min<double>(std::ceil((is_carried ? 2 : 1.25) * dashes), max_dash_count));
}

}

void make_dashes_alike(const kdl::Node& object, ItemValues& values, std::vector<ItemKey>& keys,
                       SceneContext& context)
{
    std::size_t count = dash_length_count(values);
    for (const ItemKey& key : keys)
        count = std::max(count, dash_length_count(key.values));
    if (count == 0)
        return warn_of_idle_offset(object, keys, context);
    const auto repeat = [&](ItemValues& own, const kdl::Node& node) {
        const std::size_t lengths = dash_length_count(own);
        if (!fits(lengths, count))
            context.report.error(property_span(node, dash_name),
                                 std::to_string(lengths) + " lengths do not become the " +
                                     std::to_string(count) + " of another key",
                                 "give each key of the object as many");
        repeat_dash_lengths(own, count);
    };
    repeat(values, object);
    for (ItemKey& key : keys)
        if (has_dash(key))
            repeat(key.values, *key.node);
    if (dash_length_count(values) == 0 && !keys.empty() && !has_dash(keys.front()))
        context.report.error(keys.front().place, "a later key has dashes, but the first one has none",
                             "add dash=\"…\" to this key, or to the object");
}

void add_max_dashes(std::vector<Track>& tracks, const Object& object, SourceSpan place, SceneContext& context)
{
    const Pattern pattern = shortest_pattern(tracks);
    if (pattern.dashes == 0)
        return;
    const double dashes = dashes_of(object.keys, pattern);
    if (dashes > max_dash_count)
        context.report.error(place,
                             "these strokes come to " + std::to_string(std::lround(dashes)) +
                                 " dashes; a player draws " + std::to_string(max_dash_count) +
                                 " of an object",
                             "make dashes and gaps longer, or divide the object");
    const std::int32_t limit = limit_for(dashes, object);
    if (limit > default_max_dashes)
        tracks.push_back({Property::max_dashes, {TrackKey{.time = {}, .laws = {}, .value = limit}}});
}

}
