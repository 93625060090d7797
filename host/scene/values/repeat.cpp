#include "host/scene/values/repeat.hpp"

#include "core/scene/kfb_limits.hpp"
#include "host/scene/context/limits.hpp"
#include "host/schema/property_rule.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

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

bool is_far(double pixels) { return std::abs(pixels) * 16 > kfb::max_coordinate; }

/// In the unit of scales.
double size_of(const Repeat& repeat, int number) { return power(repeat.scale, number) * scale_one; }

std::int32_t opacity_of(const Repeat& repeat, int number)
{
    return in_units(std::clamp(1 + number * repeat.opacity, 0.0, 1.0) * 255);
}

}

std::optional<ItemValues> Repeat::copy(int number, const ItemValues& use) const
{
    if (is_far(number * x) || is_far(number * y) || size_of(*this, number) > kfb::max_scale)
        return std::nullopt;
    ItemValues values;
    values[Property::x] = in_units(number * x * 16);
    values[Property::y] = in_units(number * y * 16);
    values[Property::rotation] = in_units(std::fmod(number * rotation, 360) * turn / 360);
    values.scale = in_units(size_of(*this, number));
    values[Property::opacity] = opacity_of(*this, number);
    values[Property::pivot_x] = use.get(Property::pivot_x);
    values[Property::pivot_y] = use.get(Property::pivot_y);
    return values;
}

bool Repeat::is_transparent(int number) const { return opacity_of(*this, number) == 0; }

bool Repeat::is_nothing(int number) const { return std::abs(size_of(*this, number)) < 0.5; }

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

bool has_count_for_steps(const kdl::Node& node, SceneContext& context)
{
    if (has_property(node, "count"))
        return true;
    const auto step = std::ranges::find_if(
        node.properties, [](const kdl::Property& property) { return property.name.ends_with("-step"); });
    return step == node.properties.end() ||
           context.report.error(property_span(node, step->name),
                                step->name + " is that from one copy to the next, and there is only one copy",
                                "add count=…");
}

bool report_far_copy(const kdl::Node& node, int number, const Repeat& repeat, SceneContext& context)
{
    const bool is_far_away = is_far(number * repeat.x) || is_far(number * repeat.y);
    const std::string_view step = is_far(number * repeat.x) ? "x-step"
                                  : is_far_away             ? "y-step"
                                                            : "scale-step";
    return context.report.error(property_span(node, step),
                                "with this " + std::string{step} + " the copy with the number " +
                                    std::to_string(number + 1) + " is more than " +
                                    (is_far_away ? "2047 px away" : "64 times as large"),
                                "take a smaller step, or fewer copies");
}

void warn_of_unseen_copies(const kdl::Node& node, const Repeat& repeat, SceneContext& context)
{
    for (int number = 1; number < repeat.count.value_or(1); ++number) {
        const bool is_transparent = repeat.is_transparent(number);
        if (!is_transparent && !repeat.is_nothing(number))
            continue;
        const std::string_view step = is_transparent ? "opacity-step" : "scale-step";
        return context.report.warning(
            property_span(node, step),
            "with this " + std::string{step} + " nothing is seen of the copies from number " +
                std::to_string(number + 1) +
                " on: " + (is_transparent ? "their opacity is 0" : "they have shrunk to nothing"),
            "write count=" + std::to_string(number) + ", or a step nearer to " +
                (is_transparent ? "0" : "1"));
    }
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
