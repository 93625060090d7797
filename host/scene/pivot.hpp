#pragma once

#include "host/scene/model.hpp"

namespace kfast::scene {

constexpr bool is_pivot(const Track& track)
{
    return track.property == Property::pivot_x || track.property == Property::pivot_y;
}

/// Whether `track` gives a pivot something to do.
constexpr bool turns_or_grows(const Track& track)
{
    return track.property == Property::rotation || track.property == Property::scale_x ||
           track.property == Property::scale_y;
}

}
