#include "host/svg/markup/reported_length.hpp"

#include "host/svg/markup/shortened.hpp"

#include <algorithm>

namespace kfast::svg {

std::optional<double> reported_length(std::string_view name, std::string_view text, Axis axis,
                                      const Measure& measure, const std::string& layer, art::Losses& losses)
{
    text = trimmed(text);
    if (text.empty() || text == "auto")
        return std::nullopt;
    const auto value = length(text, axis, measure);
    if (!value)
        losses.add({std::string{name} + ": " + shortened(text), layer, {}, "it is as if it were not set"});
    return value ? std::optional{std::clamp(*value, -farthest, farthest)} : std::nullopt;
}

}
