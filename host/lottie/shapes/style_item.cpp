#include "host/lottie/shapes/shapes.hpp"

#include "host/art/document/document.hpp"
#include "host/lottie/values/channel.hpp"
#include "host/lottie/values/json.hpp"
#include "host/lottie/values/ways.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace kfast::lottie {

namespace {

/// One colour in place of a gradient.
struct MeanColour {
    art::Animated<art::Rgb> colour;
    art::Channel opacity;
};

/// All numbers of a gradient at one time: offset, red, green and blue of each colour, then offset and opacity
/// of each stop of the opacity, if there are any.
struct Numbers {
    std::vector<double> list;
    friend bool operator==(const Numbers&, const Numbers&) = default;
};

struct Stop {
    double offset = 0;
    double value = 0;
};

/// Linear between stops, which are in their order.
double value_at(const std::vector<Stop>& stops, double offset)
{
    if (stops.empty())
        return 1;
    const auto next = std::ranges::lower_bound(stops, offset, {}, &Stop::offset);
    if (next == stops.begin())
        return next->value;
    const Stop& before = *std::prev(next);
    if (next == stops.end())
        return before.value;
    return std::lerp(before.value, next->value, (offset - before.offset) / (next->offset - before.offset));
}

/// Every `stride`th number from `first` to `end` is an offset, and the value is `value` numbers after it.
std::vector<Stop> stops_of(const Numbers& numbers, std::size_t first, std::size_t end, std::size_t stride,
                           std::size_t value)
{
    std::vector<Stop> stops;
    for (std::size_t i = first; i + stride <= end; i += stride)
        stops.push_back({numbers.list[i], std::clamp(numbers.list[i + value], 0.0, 1.0)});
    std::ranges::stable_sort(stops, {}, &Stop::offset);
    return stops;
}

struct Mean {
    art::Rgb colour;
    double opacity = 0;
};

Mean mean_of(const Numbers& numbers, std::size_t colour_count)
{
    constexpr int samples = 256;
    const std::size_t colours_end = std::min(4 * colour_count, numbers.list.size());
    const auto red = stops_of(numbers, 0, colours_end, 4, 1);
    const auto green = stops_of(numbers, 0, colours_end, 4, 2);
    const auto blue = stops_of(numbers, 0, colours_end, 4, 3);
    const auto opacity = stops_of(numbers, colours_end, numbers.list.size(), 2, 1);
    Mean sum;
    for (int i = 0; i < samples; ++i) {
        const double offset = (i + 0.5) / samples;
        const double seen = value_at(opacity, offset);
        const double weight = seen + 1e-9;
        sum.colour.red += weight * value_at(red, offset);
        sum.colour.green += weight * value_at(green, offset);
        sum.colour.blue += weight * value_at(blue, offset);
        sum.opacity += seen;
    }
    const double weights = sum.opacity + samples * 1e-9;
    return {{sum.colour.red / weights, sum.colour.green / weights, sum.colour.blue / weights},
            sum.opacity / samples};
}

Numbers numbers_of(const Json& value)
{
    if (!value.is_array())
        throw WrongMember(value, "is no gradient: one is a list of numbers");
    Numbers numbers;
    for (const Json& number : value)
        numbers.list.push_back(number_of(number));
    return numbers;
}

template <typename Value, typename Part>
art::Animated<Value> animated(const art::Animated<Mean>& means, Part part)
{
    std::vector<art::Key<Value>> keys;
    for (const auto& key : means.keys)
        keys.push_back({key.time, key.value.*part, key.ease});
    return art::Animated<Value>{std::move(keys)};
}

/// The mean of the colours "g" along a gradient, each weighted by how visible it is.
MeanColour read_mean_colour(const Json& style, const Reading& reading)
{
    const Json* const gradient = find_member(style, "g");
    if (!gradient)
        throw WrongMember(style, "\"g\" is missing: export the file again");
    const auto numbers =
        read_animated<Numbers>(read_property(*gradient, "k"), 0, numbers_of, reading.time, reading.budget)
            .value_or(art::Animated<Numbers>{});
    const std::size_t whole_colours = numbers.value().list.size() / 4;
    const auto max = static_cast<double>(whole_colours);
    const double count = std::clamp(number_at(*gradient, "p", max), 0.0, 65536.0);
    art::Animated<Mean> means;
    means.keys.clear();
    for (const auto& key : numbers.keys)
        means.keys.push_back({key.time, mean_of(key.value, static_cast<std::size_t>(count)), key.ease});
    return {animated<art::Rgb>(means, &Mean::colour), animated<double>(means, &Mean::opacity)};
}

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

/// The combined opacity of a gradient and of the style.
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
