#include "host/scene/items/track_builder.hpp"

#include "host/schema/property_rule.hpp"
#include "host/words/scene_words.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>

namespace kfast::scene {

namespace {

/// Objects with a fill or a stroke set their colours themselves.
std::int32_t ordinary_value(Property property)
{
    return property == Property::width ? StrokeStyle{}.width : value_without_track(property);
}

LawPair laws_for(Property property, const KeyLaws& laws)
{
    switch (property) {
    case Property::x:
    case Property::y:
    case Property::scale_x:
    case Property::scale_y:
        return laws.of_axes();
    case Property::order:
    case Property::visible:
        return {};
    default:
        return laws.of_rest();
    }
}

bool is_painted(Property property)
{
    return property == Property::fill || property == Property::stroke || property == Property::width;
}

void warn_of_idle_pivot(std::string_view name, SourceSpan place, SceneContext& context)
{
    context.report.warning(place, std::string{name} + " does nothing where nothing turns or grows",
                           "add rotate=… or scale=…, or remove " + std::string{name});
}

void warn_of_idle_pivots(const kdl::Node& node, std::span<const TimedQuantity> timed, SceneContext& context)
{
    for (const Property pivot : {Property::pivot_x, Property::pivot_y}) {
        const std::string_view name = property_name(pivot);
        if (has_property(node, name))
            warn_of_idle_pivot(name, property_span(node, name), context);
        for (const TimedQuantity& quantity : timed)
            if (gives(quantity, pivot))
                warn_of_idle_pivot(name, quantity.place, context);
    }
}

/// The first key has a value for everything that any key sets. No transition leaves the last one.
std::vector<TrackKey> keys_of(Property property, std::int32_t first, std::span<const ItemKey> keys)
{
    std::vector<TrackKey> track;
    for (const ItemKey& key : keys) {
        const auto own = key.values.get(property);
        if (!own && &key != keys.data())
            continue;
        track.push_back({key.time, laws_for(property, key.laws), own.value_or(first), key.place});
    }
    track.back().laws = {};
    return track;
}

Track build_track(Property property, std::optional<std::int32_t> own, const KeysOfItem& item)
{
    const auto sets_it = [&](const ItemKey& key) { return key.values.get(property).has_value(); };
    const std::int32_t ordinary = ordinary_value(property);
    const std::int32_t first = own.value_or(ordinary);
    if (std::ranges::any_of(item.keys, sets_it))
        return {property, keys_of(property, first, item.keys), false, item.driver};
    if (is_painted(property) || first == ordinary)
        return {property, {}};
    return {property, {TrackKey{.time = {}, .laws = {}, .value = first}}};
}

}

std::vector<Track> build_tracks(const kdl::Node& node, const ItemValues& values, const KeysOfItem& keys,
                                std::span<TimedQuantity> timed, SceneContext& context)
{
    std::vector<Track> tracks;
    for (std::size_t i = 0; i < property_count; ++i) {
        const auto property = static_cast<Property>(i);
        Track* const by_times = find_track(timed, property);
        Track track = by_times != nullptr ? *by_times : build_track(property, values.get(property), keys);
        if (!track.keys.empty())
            tracks.push_back(std::move(track));
    }
    if (!keys.needs_pivot && std::ranges::none_of(tracks, needs_pivot)) {
        std::erase_if(tracks, is_pivot);
        warn_of_idle_pivots(node, timed, context);
    }
    return tracks;
}

std::vector<Key> take_drawings(std::span<ItemKey> keys)
{
    std::vector<Key> drawings;
    for (ItemKey& key : keys)
        if (key.drawing)
            drawings.push_back({.time = key.time,
                                .laws = key.laws.of_axes(),
                                .match = key.match.value_or(Match::count),
                                .drawing = std::move(*key.drawing),
                                .depths = std::move(key.depths),
                                .place = key.place,
                                .sectors = std::move(key.sectors),
                                .letters = std::move(key.letters)});
    if (!drawings.empty())
        drawings.back().laws = {};
    return drawings;
}

namespace {

class DuplicateQuantities {
public:
    DuplicateQuantities(std::span<const TimedQuantity> timed, const ItemValues& values,
                        std::span<const ItemKey> keys, SceneContext& context)
        : timed_{timed}, values_{values}, keys_{keys}, context_{context}
    {
    }

    void refuse()
    {
        for (std::size_t i = 0; i < timed_.size() && !context_.report.full(); ++i) {
            refuse_duplicate(timed_[i], timed_.first(i));
            if (gives(timed_[i], Property::along))
                refuse_position(timed_[i]);
        }
    }

private:
    void refuse_duplicate(const TimedQuantity& quantity, std::span<const TimedQuantity> earlier)
    {
        for (const Track& track : quantity.tracks) {
            const auto giver = other_giver(track.property, earlier);
            if (!giver)
                continue;
            const std::string name{property_name(track.property)};
            context_.report.error(quantity.place, name + " is given twice: by this track, and by " + *giver,
                                  "leave it to one of them");
            return;
        }
    }

    void refuse_position(const TimedQuantity& path)
    {
        for (const Property property : {Property::x, Property::y})
            if (const auto giver = other_giver(property, timed_)) {
                const std::string name{property_name(property)};
                context_.report.error(
                    path.place, "the path says where the item is, but " + name + " is given by " + *giver,
                    "leave it out, or put the item into a group that moves");
                return;
            }
    }

    std::optional<std::string> other_giver(Property property, std::span<const TimedQuantity> tracks) const
    {
        const auto sets_it = [property](const ItemKey& key) { return key.values.get(property).has_value(); };
        const auto moves_it = [property](const TimedQuantity& other) { return gives(other, property); };
        if (values_.get(property))
            return "its item";
        if (const auto key = std::ranges::find_if(keys_, sets_it); key != keys_.end())
            return "the key on " + context_.report.line(key->place);
        if (const auto track = std::ranges::find_if(tracks, moves_it); track != tracks.end())
            return "the track on " + context_.report.line(track->place);
        return std::nullopt;
    }

    std::span<const TimedQuantity> timed_;
    const ItemValues& values_;
    std::span<const ItemKey> keys_;
    SceneContext& context_;
};

}

void refuse_duplicate_quantities(std::span<const TimedQuantity> timed, const ItemValues& values,
                                 std::span<const ItemKey> keys, SceneContext& context)
{
    DuplicateQuantities{timed, values, keys, context}.refuse();
}

}
