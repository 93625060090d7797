#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/values/item_values.hpp"

#include <cstddef>

namespace kfast::scene {

/// A number or a list of them, as in dash="8 4": lengths of dashes and gaps alternately. An odd number of
/// them is repeated, so that there is a gap for each dash.
bool read_dash(const kdl::Value& value, ItemValues& values, SceneContext& context);

template <class Target>
bool read_dash(const kdl::Value& value, Target& target, SceneContext& context)
{
    return read_dash(value, target.values, context);
}

/// The lengths of the pattern in `values`; 0 if it has none.
std::size_t dash_length_count(const ItemValues& values);

/// Repeats the lengths of `values` until there are so many of them.
void repeat_dash_lengths(ItemValues& values, std::size_t count);

template <class Target>
inline constexpr std::array dash_rules{
    PropertyRule<Target>{"dash", read_dash<Target>, any_text},
    PropertyRule<Target>{"dash-offset", read_own_value<Property::dash_offset>,
                         kind_of(Property::dash_offset)},
};

}
