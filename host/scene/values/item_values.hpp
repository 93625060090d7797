#pragma once

#include "core/math/stroke_trimmer.hpp"
#include "core/scene/property.hpp"
#include "host/kdl/document.hpp"
#include "host/scene/context/limits.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/model.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/schema/property_rule.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace kfast::scene {

/// What a node sets of the quantities of its item, in the units of core/scene/property.hpp.
struct ItemValues {
    std::optional<std::int32_t>& operator[](Property property)
    {
        return own[static_cast<std::size_t>(property)];
    }
    /// The value; that of one axis wins over `scale`.
    std::optional<std::int32_t> get(Property property) const;

    std::array<std::optional<std::int32_t>, property_count> own;
    std::optional<std::int32_t> scale; ///< of both axes
};

/// What the shares of a trim are shares of. An object of pies alone is trimmed by its angles
/// (trim_sectors()).
inline constexpr std::array trim_words{Word<TrimMode>{"each", TrimMode::each},
                                       Word<TrimMode>{"together", TrimMode::together}};

/// What nodes and keys may write as a quantity. `width` may be 0.
constexpr ValueKind kind_of(Property property)
{
    switch (property) {
    case Property::x:
    case Property::y:
    case Property::z:
    case Property::pivot_x:
    case Property::pivot_y:
        return ValueKind::pixels(coordinates);
    case Property::rotation_x:
    case Property::rotation_y:
    case Property::rotation:
        return ValueKind::degrees({-16 * 360, 16 * 360});
    case Property::scale_x:
    case Property::scale_y:
        return ValueKind::number({-64, 64});
    case Property::along:
    case Property::opacity:
    case Property::trim_from:
    case Property::trim_to:
        return ValueKind::number({0, 1});
    case Property::trim_offset:
        return ValueKind::number({-16, 16});
    case Property::trim_mode:
        return ValueKind::one_of<trim_words>();
    case Property::order:
        return ValueKind::whole({kfb::min_coordinate, kfb::max_coordinate});
    case Property::visible:
        return truth;
    case Property::fill:
    case Property::stroke:
        return any_colour;
    case Property::width:
        return ValueKind::pixels({0, widest_stroke});
    case Property::dash_offset:
        return ValueKind::pixels({-max_dash_pixels, max_dash_pixels});
    case Property::dash_1:
    case Property::gap_1:
    case Property::dash_2:
    case Property::gap_2:
    case Property::dash_3:
    case Property::gap_3:
        return ValueKind::pixels({0, max_dash_pixels});
    case Property::max_dashes:
        return ValueKind::whole({1, max_dash_count});
    }
    return {};
}

/// The value in the unit of the property, rounded once, halves away from zero. `width` may be 0.
std::optional<std::int32_t> read_item_value(Property property, const kdl::Value& value,
                                            SceneContext& context);

template <Property property, class Target>
bool read_own_value(const kdl::Value& value, Target& target, SceneContext& context)
{
    return assign(read_item_value(property, value, context), target.values[property]);
}

/// "rotate" and "rotate-z" are two names of one rotation. False if `rotation` is given already.
bool read_rotation(const kdl::Value& value, std::optional<std::int32_t>& rotation, SceneContext& context);

template <class Target>
bool read_rotation(const kdl::Value& value, Target& target, SceneContext& context)
{
    return read_rotation(value, target.values[Property::rotation], context);
}

template <class Target>
bool read_scale(const kdl::Value& value, Target& target, SceneContext& context)
{
    return assign(read_item_value(Property::scale_x, value, context), target.values.scale);
}

// The properties that nodes of several kinds take; a Target has a member ItemValues `values`.

template <class Target>
inline constexpr std::array place_rules{
    PropertyRule<Target>{"x", read_own_value<Property::x>, kind_of(Property::x)},
    PropertyRule<Target>{"y", read_own_value<Property::y>, kind_of(Property::y)},
    PropertyRule<Target>{"z", read_own_value<Property::z>, kind_of(Property::z)},
    PropertyRule<Target>{"rotate", read_rotation<Target>, kind_of(Property::rotation)},
    PropertyRule<Target>{"rotate-x", read_own_value<Property::rotation_x>, kind_of(Property::rotation_x)},
    PropertyRule<Target>{"rotate-y", read_own_value<Property::rotation_y>, kind_of(Property::rotation_y)},
    PropertyRule<Target>{"rotate-z", read_rotation<Target>, kind_of(Property::rotation)},
    PropertyRule<Target>{"scale", read_scale, kind_of(Property::scale_x)},
    PropertyRule<Target>{"scale-x", read_own_value<Property::scale_x>, kind_of(Property::scale_x)},
    PropertyRule<Target>{"scale-y", read_own_value<Property::scale_y>, kind_of(Property::scale_y)},
};

template <class Target>
inline constexpr std::array pivot_rules{
    PropertyRule<Target>{"pivot-x", read_own_value<Property::pivot_x>, kind_of(Property::pivot_x)},
    PropertyRule<Target>{"pivot-y", read_own_value<Property::pivot_y>, kind_of(Property::pivot_y)},
};

template <class Target>
inline constexpr std::array show_rules{
    PropertyRule<Target>{"opacity", read_own_value<Property::opacity>, kind_of(Property::opacity)},
    PropertyRule<Target>{"order", read_own_value<Property::order>, kind_of(Property::order)},
    PropertyRule<Target>{"visible", read_own_value<Property::visible>, kind_of(Property::visible)},
};

template <class Target>
inline constexpr std::array trim_rules{
    PropertyRule<Target>{"trim-from", read_own_value<Property::trim_from>, kind_of(Property::trim_from)},
    PropertyRule<Target>{"trim-to", read_own_value<Property::trim_to>, kind_of(Property::trim_to)},
    PropertyRule<Target>{"trim-offset", read_own_value<Property::trim_offset>,
                         kind_of(Property::trim_offset)},
};

/// Sets what `values` lack of the pivot: the centre of the box of the vertices of the first drawing that is
/// not empty, rounded to 1/16 px, halves up. Control points do not count.
void set_default_pivot(const std::vector<Key>& keys, ItemValues& values);
/// Sets what `values` lack of the pivot to this point.
void set_default_pivot(Point pivot, ItemValues& values);

}
