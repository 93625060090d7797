#include "host/svg/poses/layer_time.hpp"

#include "host/geometry/path_scanner.hpp"
#include "host/svg/markup/length.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace kfast::svg {
namespace {

bool take(std::string_view& text, std::string_view beginning)
{
    const bool found =
        text.size() >= beginning.size() &&
        std::ranges::equal(text.substr(0, beginning.size()), beginning, [](char one, char other) {
            return (one >= 'A' && one <= 'Z' ? one - 'A' + 'a' : one) == other;
        });
    if (found)
        text = trimmed(text.substr(beginning.size()));
    return found;
}

/// Frames in a unit of time.
std::optional<double> frames_in(std::string_view unit, double frame_rate)
{
    if (unit == "s")
        return frame_rate;
    if (unit == "ms")
        return frame_rate / 1000;
    return unit.empty() ? std::optional{1.0} : std::nullopt;
}

}

std::optional<double> layer_time(std::string_view name, double frame_rate)
{
    std::string_view text = trimmed(name);
    std::optional<double> unit;
    if (take(text, "(s)"))
        unit = frame_rate;
    else if (take(text, "(ms)"))
        unit = frame_rate / 1000;
    else if (take(text, "frame") || take(text, "f"))
        unit = 1;
    scene::PathScanner scanner{text};
    const auto value = scanner.number();
    if (!value || *value < 0)
        return std::nullopt;
    const std::string_view rest = trimmed(text.substr(scanner.offset()));
    const std::string_view behind = trimmed(rest.substr(0, std::min(rest.find(':'), rest.size())));
    if (!unit)
        unit = frames_in(behind, frame_rate);
    else if (!behind.empty())
        return std::nullopt;
    return unit ? std::optional{*value * *unit} : std::nullopt;
}

}
