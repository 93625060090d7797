#pragma once

#include "host/scene/items/key_reader.hpp"
#include "host/scene/values/item_values.hpp"
#include "host/scene/values/timed_quantity.hpp"

#include <span>

namespace kfast::scene {

/// Which scales of a use change their sign: x exchanges left and right.
struct Mirror {
    bool x = false;
    bool y = false;
};

/// Mirrors what an item is and what its keys and tracks make of it.
inline void mirror(const Mirror& axes, ItemValues& item, std::span<ItemKey> keys,
                   std::span<TimedQuantity> timed)
{
    const auto mirror_axis = [&](Property scale) {
        item[scale] = -item.get(scale).value_or(scale_one);
        for (ItemKey& key : keys)
            if (const auto own = key.values.get(scale))
                key.values[scale] = -*own;
        if (Track* const track = find_track(timed, scale))
            for (TrackKey& key : track->keys)
                key.value = -key.value;
    };
    if (axes.x)
        mirror_axis(Property::scale_x);
    if (axes.y)
        mirror_axis(Property::scale_y);
}

}
