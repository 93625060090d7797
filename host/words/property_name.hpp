#pragma once

#include "core/scene/property.hpp"

#include <array>
#include <string_view>

namespace kfast {

/// As the scene language calls it.
constexpr std::string_view property_name(Property property)
{
    constexpr std::array<std::string_view, property_count> names{
        "x",       "y",     "z",       "rotate-x", "rotate-y", "rotate", "scale-x", "scale-y", "pivot-x",
        "pivot-y", "along", "opacity", "order",    "visible",  "fill",   "stroke",  "width"};
    return names[static_cast<std::size_t>(property)];
}

}
