#include "host/scene/items/object_dashes.hpp"

#include "host/scene/items/dash_count.hpp"
#include "host/scene/values/dash_reader.hpp"
#include "host/schema/property_rule.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
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

/// How many times as long strokes may become by what carries them.
double growth_of(const Object& object, const SceneContext& context)
{
    if (object.skin)
        return growth_by(context.skeletons.entries[object.skin->bones].bones);
    return object.backbone_keys.empty() ? 1 : growth_by(object.backbone_keys);
}

/// With room for pieces that a trim leaves. What comes from outside has any length.
std::int32_t limit_for(double dashes, const Object& object, const SceneContext& context)
{
    if (object.live || object.label)
        return max_dash_count;
    const double grown = std::ceil(1.25 * growth_of(object, context) * dashes);
    return static_cast<std::int32_t>(std::min<double>(grown, max_dash_count));
}

void warn_of_many_dashes(SourceSpan place, SceneContext& context)
{
    context.report.warning(place,
                           "between keys these strokes may come to more than " +
                               std::to_string(max_dash_count) + " dashes; the rest of them is drawn whole",
                           "let only the gaps become 0, as in dash=\"20 0\", or only the dashes; or keep "
                           "both longer");
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
    const DashPattern pattern = shortest_pattern(tracks);
    if (pattern.dashes == 0)
        return;
    const auto moved = shortest_pattern_between_keys(tracks);
    const double dashes = dashes_of(object.keys, pattern);
    const double between = dashes_between(object.keys, moved ? moved->pattern : pattern);
    if (dashes > max_dash_count)
        context.report.error(place,
                             "these strokes come to " + std::to_string(std::lround(dashes)) +
                                 " dashes; a player draws " + std::to_string(max_dash_count) +
                                 " of an object",
                             "make dashes and gaps longer, or divide the object");
    else if (between > max_dash_count)
        warn_of_many_dashes(moved ? moved->place : place, context);
    const std::int32_t limit = limit_for(std::max(dashes, between), object, context);
    if (limit > default_max_dashes)
        tracks.push_back({Property::max_dashes, {TrackKey{.time = {}, .laws = {}, .value = limit}}});
}

}
