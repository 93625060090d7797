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

/// Whether `track` gives a pivot something to do: the item turns or grows about it, or moves it along a path.
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
    bool has_depths = false; ///< of a wire frame: its line is as wide as at the pivot, whatever turns it
};

/// What of the item `node` is not the ordinary or changes. `values` are those of the item itself, its pivot
/// included; of fill, stroke and width there are tracks only where keys set them, of the pivot only where the
/// item turns or grows about it, or has depths. `timed` wins over `values`.
std::vector<Track> build_tracks(const kdl::Node& node, const ItemValues& values, const KeysOfItem& keys,
                                std::span<TimedQuantity> timed, SceneContext& context);

/// The drawings of `keys`, with the laws of their ways; `keys` have none afterwards.
std::vector<Key> take_drawings(std::span<ItemKey> keys);

/// Reports each of `timed` that gives what the item itself (`values`), one of its keys or another track gives
/// as well, and a path beside a position.
void refuse_duplicate_quantities(std::span<const TimedQuantity> timed, const ItemValues& values,
                                 std::span<const ItemKey> keys, SceneContext& context);

}
