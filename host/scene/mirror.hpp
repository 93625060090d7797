#pragma once

#include "host/scene/item_values.hpp"
#include "host/scene/key_reader.hpp"

#include <span>

namespace kfast::scene {

/// Which scales of a use change their sign: x exchanges left and right.
struct Mirror {
    bool x = false;
    bool y = false;
};

/// Mirrors what an item is and what its keys make of it.
inline void mirror(const Mirror& axes, ItemValues& item, std::span<ItemKey> keys)
{
    const auto mirror_axis = [&](Property scale) {
        item[scale] = -item.get(scale).value_or(scale_one);
        for (ItemKey& key : keys)
            if (const auto own = key.values.get(scale))
                key.values[scale] = -*own;
    };
    if (axes.x)
        mirror_axis(Property::scale_x);
    if (axes.y)
        mirror_axis(Property::scale_y);
}

}
