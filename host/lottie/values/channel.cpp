#include "host/lottie/values/channel.hpp"

#include "host/lottie/values/member.hpp"
#include "host/lottie/values/ways.hpp"

#include <algorithm>

namespace kfast::lottie {
namespace {

/// A number alone stands for all components.
double component(const Json& value, std::size_t index, double default_value)
{
    if (!value.is_array())
        return number_of(value);
    return index < value.size() ? number_of(value[index]) : default_value;
}

bool counts_to_255(const Json& colour)
{
    return colour.is_array() && std::any_of(colour.begin(), colour.end(), [](const Json& channel) {
               return channel.is_number() && channel.get<double>() > 1;
           });
}

/// The first versions of the format counted channels to 255.
double channel_unit(const Property& property)
{
    const bool bytes = property.value ? counts_to_255(*property.value)
                                      : std::ranges::any_of(property.keys, [](const FileKey& key) {
                                            return counts_to_255(*key.begin);
                                        });
    return bytes ? 1.0 / 255 : 1;
}

art::Rgb colour_of(const Json& value, double unit)
{
    const auto channel = [&](std::size_t index) {
        return std::clamp(component(value, index, 0) * unit, 0.0, 1.0);
    };
    if (!value.is_array())
        throw WrongMember(value, "is no colour: one is a list of red, green and blue");
    return {channel(0), channel(1), channel(2)};
}

}

art::Channel read_channel(const Json& owner, const char* name, std::size_t index, double default_value,
                          double factor, const LayerTime& time, art::Budget& budget)
{
    const auto value_of = [&](const Json& value) {
        return component(value, index, default_value / factor) * factor;
    };
    return read_animated<double>(read_property(owner, name), index, value_of, time, budget)
        .value_or(art::Channel{default_value});
}

art::Animated<art::Rgb> read_colour(const Json& owner, const char* name, const LayerTime& time,
                                    art::Budget& budget)
{
    const Property property = read_property(owner, name);
    const double unit = channel_unit(property);
    const auto value_of = [&](const Json& value) { return colour_of(value, unit); };
    return read_animated<art::Rgb>(property, 0, value_of, time, budget).value_or(art::Rgb{});
}

}
