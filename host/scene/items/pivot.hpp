#pragma once

#include "host/scene/model.hpp"

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

}
