#include "host/lottie/shapes/style_item.hpp"

#include "host/lottie/shapes/gradient.hpp"
#include "host/lottie/values/combined_channel.hpp"
#include "host/lottie/values/member.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace kfast::lottie {
namespace {

using art::Channel;

Channel read_opacity(const Json& item, const Reading& reading)
{
    return read_channel(item, "o", 0, 1, 0.01, reading.time, reading.budget);
}

FillRule fill_rule(const Json& item)
{
    return whole_at(item, "r", 1) == 2 ? FillRule::even_odd : FillRule::nonzero;
}

Cap cap_of(const Json& item)
{
    switch (whole_at(item, "lc", 2)) {
    case 1:
        return Cap::butt;
    case 3:
        return Cap::square;
    default:
        return Cap::round;
    }
}

Join join_of(const Json& item)
{
    switch (whole_at(item, "lj", 2)) {
    case 1:
        return Join::miter;
    case 3:
        return Join::bevel;
    default:
        return Join::round;
    }
}

double miter_limit(const Json& item, const Reading& reading)
{
    const double limit = number_at(item, "ml", 0);
    if (limit > 0)
        return limit;
    const Channel later = read_channel(item, "ml2", 0, 4, 1, reading.time, reading.budget);
    return later.value() > 0 ? later.value() : 4;
}

Dashes read_dashes(const Json& item, const Reading& reading)
{
    Dashes dashes;
    if (!find_member(item, "d"))
        return dashes;
    for (const Json& part : array_at(item, "d")) {
        Channel length = read_channel(part, "v", 0, 0, 1, reading.time, reading.budget);
        if (text_at(part, "n") == "o")
            dashes.offset = std::move(length);
        else
            dashes.lengths.push_back(std::move(length));
    }
    return dashes;
}

void read_fill(StyleItem& style, const Json& item, const Reading& reading)
{
    style.fill = art::Fill{read_colour(item, "c", reading.time, reading.budget), read_opacity(item, reading),
                           fill_rule(item)};
}

void read_line(StyleItem& style, const Json& item, const Reading& reading)
{
    art::StrokeStyle stroke;
    stroke.opacity = read_opacity(item, reading);
    stroke.width = read_channel(item, "w", 0, 1, 1, reading.time, reading.budget);
    stroke.cap = cap_of(item);
    stroke.join = join_of(item);
    stroke.miter_limit = miter_limit(item, reading);
    style.stroke = std::move(stroke);
    style.dashes = read_dashes(item, reading);
}

void read_stroke(StyleItem& style, const Json& item, const Reading& reading)
{
    read_line(style, item, reading);
    style.stroke->colour = read_colour(item, "c", reading.time, reading.budget);
}

/// As much as is seen of a gradient, and of the style.
Channel seen(const Channel& style, const Channel& gradient, const Reading& reading)
{
    return combined([&](double time) { return style.at(time) * gradient.at(time); }, {&style, &gradient},
                    Dependence::linear, 1.0 / 1024, reading.budget);
}

void read_gradient_fill(StyleItem& style, const Json& item, const Reading& reading)
{
    const MeanColour mean = read_mean_colour(item, reading);
    style.fill =
        art::Fill{mean.colour, seen(read_opacity(item, reading), mean.opacity, reading), fill_rule(item)};
    reading.losses.add({"gradient of a fill", reading.layer, std::nullopt, "its mean colour"});
}

void read_gradient_stroke(StyleItem& style, const Json& item, const Reading& reading)
{
    const MeanColour mean = read_mean_colour(item, reading);
    read_line(style, item, reading);
    style.stroke->colour = mean.colour;
    style.stroke->opacity = seen(style.stroke->opacity, mean.opacity, reading);
    reading.losses.add({"gradient of a stroke", reading.layer, std::nullopt, "its mean colour"});
}

struct StyleType {
    std::string_view name;
    void (*read)(StyleItem&, const Json&, const Reading&);
};

constexpr std::array style_types{StyleType{"fl", read_fill}, StyleType{"st", read_stroke},
                                 StyleType{"gf", read_gradient_fill}, StyleType{"gs", read_gradient_stroke}};

const StyleType* find_style_type(std::string_view name)
{
    const auto type = std::ranges::find(style_types, name, &StyleType::name);
    return type == style_types.end() ? nullptr : &*type;
}

}

bool is_style(std::string_view type) { return find_style_type(type) != nullptr; }

StyleItem read_style_item(const Json& item, const Reading& reading)
{
    StyleItem style;
    style.name = text_at(item, "nm");
    find_style_type(text_at(item, "ty"))->read(style, item, reading);
    return style;
}

}
