#include "host/scene/values/repeat.hpp"

#include "core/scene/kfb_limits.hpp"
#include "host/scene/context/limits.hpp"
#include "host/schema/property_rule.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace kfast::scene {

namespace {

constexpr int turn = 65536; ///< in the unit of rotations

/// Not std::pow, which platforms round differently.
double power(double base, int exponent)
{
    double product = 1;
    for (; exponent > 0; --exponent)
        product *= base;
    return product;
}

std::int32_t in_units(double value) { return static_cast<std::int32_t>(std::lround(value)); }

}

std::optional<ItemValues> Repeat::copy(int number, const ItemValues& use) const
{
    const double place_x = number * x * 16;
    const double place_y = number * y * 16;
    const double grown = power(scale, number) * scale_one;
    if (std::max(std::abs(place_x), std::abs(place_y)) > kfb::max_coordinate || grown > kfb::max_scale)
        return std::nullopt;
    ItemValues values;
    values[Property::x] = in_units(place_x);
    values[Property::y] = in_units(place_y);
    values[Property::rotation] = in_units(std::fmod(number * rotation, 360) * turn / 360);
    values.scale = in_units(grown);
    values[Property::opacity] = in_units(std::clamp(1 + number * opacity, 0.0, 1.0) * 255);
    values[Property::pivot_x] = use.get(Property::pivot_x);
    values[Property::pivot_y] = use.get(Property::pivot_y);
    return values;
}

std::optional<Time> Repeat::delay_of(int number, std::optional<Time> first) const
{
    const std::int64_t ticks = first.value_or(Time{}).ticks + std::int64_t{number} * delay.ticks;
    if (ticks < -kfb::max_time || ticks > kfb::max_time)
        return std::nullopt;
    return Time{static_cast<std::int32_t>(ticks)};
}

bool read_repeat_count(const kdl::Value& value, Repeat& repeat, SceneContext& context)
{
    repeat.count = read_whole_number(value, copies, context.report);
    return repeat.count.has_value();
}

bool read_colour_step(const kdl::Value& value, Repeat& repeat, SceneContext& context)
{
    if (!assign(read_whole_number(value, colour_steps, context.report), repeat.colour))
        return false;
    if (context.palette.declared() == 0)
        return context.report.error(value.place, "these are steps along the palette, and this scene has none",
                                    "add palette { NAME \"#rrggbb\"; NAME \"#rrggbb\" }");
    return context.palette.use_declared() || report_too_many_colours(value.place, context);
}

bool has_count_for_steps(const kdl::Node& node, const Repeat& repeat, SceneContext& context)
{
    if (repeat.count)
        return true;
    const auto step = std::ranges::find_if(
        node.properties, [](const kdl::Property& property) { return property.name.ends_with("-step"); });
    return step == node.properties.end() ||
           context.report.error(property_span(node, step->name),
                                step->name + " is that from one copy to the next, and there is one",
                                "add count=…");
}

bool report_far_copy(const kdl::Node& node, int number, SceneContext& context)
{
    return context.report.error(property_span(node, "count"),
                                "the copy with the number " + std::to_string(number + 1) +
                                    " is more than 2047 px away, or more than 64 times as large",
                                "take smaller steps, or fewer copies");
}

bool report_late_copy(const kdl::Node& node, int number, SceneContext& context)
{
    return context.report.error(property_span(node, "count"),
                                "the delay of the copy with the number " + std::to_string(number + 1) +
                                    " is more than " + std::to_string(max_frames) + " frames",
                                "take a smaller delay-step, or fewer copies");
}

std::vector<Track> fixed_tracks(const ItemValues& values)
{
    std::vector<Track> tracks;
    for (std::size_t i = 0; i < property_count; ++i) {
        const auto property = static_cast<Property>(i);
        const auto value = values.get(property);
        if (value && *value != value_without_track(property))
            tracks.push_back({property, {TrackKey{.time = {}, .laws = {}, .value = *value}}});
    }
    return tracks;
}

}
