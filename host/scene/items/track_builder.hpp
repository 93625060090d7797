#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/items/key_reader.hpp"
#include "host/scene/model.hpp"
#include "host/scene/values/item_values.hpp"
#include "host/scene/values/timed_quantity.hpp"

#include <span>
#include <vector>

namespace kfast::scene {

constexpr bool is_pivot(const Track& track)
{
    return track.property == Property::pivot_x || track.property == Property::pivot_y;
}

/// Whether `track` makes a pivot matter: the item rotates or scales about it, or moves it along a path.
constexpr bool needs_pivot(const Track& track)
{
    switch (track.property) {
    case Property::rotation_x:
    case Property::rotation_y:
    case Property::rotation:
    case Property::scale_x:
    case Property::scale_y:
    case Property::along:
        return true;
    default:
        return false;
    }
}

/// The keys that an item has itself, and what they go by.
struct KeysOfItem {
    std::span<const ItemKey> keys;
    Driver driver;
    /// It has a pivot in any case: the line of a wire frame is as wide as there, copies turn about it.
    bool needs_pivot = false;
};

/// Tracks for all that is not the default or changes in the item `node`. `values` are those of the item
/// itself, its pivot included; fill, stroke and width have tracks only if keys set them, the pivot only if
/// the item rotates or scales about it, or needs it. `timed` takes precedence over `values`.
std::vector<Track> build_tracks(const kdl::Node& node, const ItemValues& values, const KeysOfItem& keys,
                                std::span<TimedQuantity> timed, SceneContext& context);

/// Takes the drawings of `keys`, with the laws of their transitions; `keys` have none afterwards.
std::vector<Key> take_drawings(std::span<ItemKey> keys);

/// Reports each of `timed` that sets what the item itself (`values`), one of its keys or another track sets
/// as well, and a path beside a position.
void refuse_duplicate_quantities(std::span<const TimedQuantity> timed, const ItemValues& values,
                                 std::span<const ItemKey> keys, SceneContext& context);

}
