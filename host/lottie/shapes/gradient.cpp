#include "host/lottie/shapes/gradient.hpp"

#include "host/lottie/values/member.hpp"
#include "host/lottie/values/ways.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace kfast::lottie {
namespace {

/// All numbers of a gradient at one moment: offset, red, green and blue of each colour, then offset and
/// opacity of each stop of the opacity, if there are any.
struct Numbers {
    std::vector<double> list;
    friend bool operator==(const Numbers&, const Numbers&) = default;
};

struct Stop {
    double offset = 0;
    double value = 0;
};

/// Straight between stops, which stand in their order.
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

/// Every `stride`th number from `first` to `end` is an offset, and the value stands `value` behind it.
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

}

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

}
