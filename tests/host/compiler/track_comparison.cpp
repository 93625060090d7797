#include "tests/host/compiler/track_comparison.hpp"

#include "tests/host/compiler/law_comparison.hpp"

#include <algorithm>
#include <doctest/doctest.h>

namespace kfast::test {
namespace {

bool needs_pivot(const scene::Item& item);

bool changes_nothing(const scene::Track& track, const scene::Item& item)
{
    const auto* object = std::get_if<scene::Object>(&item.content);
    const std::int32_t value = track.keys.front().value;
    switch (track.property) {
    case Property::along:
        return false;
    case Property::scale_x:
    case Property::scale_y:
        return track.keys.size() == 1 && value == 4096;
    case Property::opacity:
        return track.keys.size() == 1 && value == 255;
    case Property::visible:
        return track.keys.size() == 1 && value == 1;
    case Property::max_dashes:
        return track.keys.size() == 1 && value == default_max_dashes;
    case Property::trim_to:
        return track.keys.size() == 1 && value == path_whole;
    case Property::fill:
        return track.keys.size() == 1 && static_cast<std::size_t>(value) == *object->fill;
    case Property::stroke:
        return track.keys.size() == 1 && static_cast<std::size_t>(value) == object->stroke->colour;
    case Property::width:
        return track.keys.size() == 1 && value == object->stroke->width;
    case Property::pivot_x:
    case Property::pivot_y:
        return (track.keys.size() == 1 && value == 0) || !needs_pivot(item);
    default:
        return track.keys.size() == 1 && value == 0;
    }
}

bool needs_pivot(const scene::Item& item)
{
    const auto* object = std::get_if<scene::Object>(&item.content);
    if (object != nullptr && object->has_depths)
        return true;
    return std::ranges::any_of(item.tracks, [&item](const scene::Track& track) {
        const bool is_of_pivot =
            (track.property >= Property::rotation_x && track.property <= Property::scale_y) ||
            track.property == Property::along;
        return is_of_pivot && !changes_nothing(track, item);
    });
}

void compare_track(const SceneView& view, const TrackView& read, const scene::Track& track)
{
    REQUIRE(read.is_fixed == (track.keys.size() == 1));
    if (read.is_fixed) {
        CHECK(read.value == track.keys.front().value);
        return;
    }
    REQUIRE(read.is_smooth == track.is_smooth);
    CHECK(read.keys.key_times().driver() == track.driver);
    TrackKeyCursor keys = read.keys;
    for (const scene::TrackKey& key : track.keys) {
        REQUIRE(!keys.at_end());
        const TrackKey stored = keys.next();
        CHECK(stored.time == key.time);
        CHECK(stored.value == key.value);
        compare_laws(view, stored.laws, track.is_smooth ? LawPair{} : key.laws, keys.at_end());
    }
    CHECK(keys.at_end());
}

}

void compare_tracks(const SceneView& view, TrackCursor cursor, const scene::Item& item)
{
    for (const scene::Track& track : item.tracks) {
        TrackCursor ahead = cursor;
        if (!ahead.at_end() && ahead.next().property == track.property)
            compare_track(view, cursor.next(), track);
        else
            CHECK(changes_nothing(track, item));
    }
    CHECK(cursor.at_end());
}

}
