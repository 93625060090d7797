#include "host/svg/style/colour.hpp"

#include "host/geometry/path_scanner.hpp"
#include "host/scene/context/palette.hpp"
#include "host/svg/markup/length.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace kfast::svg {
namespace {

std::string lower_case(std::string_view text)
{
    std::string result{text};
    std::ranges::transform(result, result.begin(),
                           [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    return result;
}

struct Component {
    double value;
    std::string_view unit;
};

/// The arguments in parentheses: numbers and percentages, with space, commas or a slash between them.
std::optional<std::vector<Component>> components(std::string_view text)
{
    std::vector<Component> result;
    for (text = trimmed(text); !text.empty();) {
        scene::PathScanner scanner{text};
        const auto value = scanner.number();
        if (!value)
            return std::nullopt;
        const std::size_t end = std::min(text.find_first_of(" \t\r\n,/", scanner.offset()), text.size());
        result.push_back({*value, text.substr(scanner.offset(), end - scanner.offset())});
        text = trimmed(text.substr(end));
        if (text.starts_with(',') || text.starts_with('/'))
            text = trimmed(text.substr(1));
    }
    return result;
}

/// `whole` is 100 % as a plain number.
double share_of(const Component& component, double whole)
{
    return std::clamp(component.value / (component.unit == "%" ? 100 : whole), 0.0, 1.0);
}

double degrees(const Component& hue)
{
    if (hue.unit == "turn")
        return hue.value * 360;
    if (hue.unit == "rad")
        return hue.value * 180 / 3.14159265358979323846;
    return hue.unit == "grad" ? hue.value * 0.9 : hue.value;
}

art::Rgb of_hsl(double hue, double saturation, double lightness)
{
    const auto channel = [&](double shift) {
        const double k = std::fmod(std::fmod(shift + hue / 30, 12) + 12, 12);
        return lightness - saturation * std::min(lightness, 1 - lightness) *
                               std::max(-1.0, std::min({k - 3, 9 - k, 1.0}));
    };
    return {channel(0), channel(8), channel(4)};
}

/// With commas, the older form of CSS, all channels are numbers or all are percentages.
bool is_mixed(std::string_view arguments, const std::vector<Component>& parts)
{
    return arguments.find(',') != arguments.npos &&
           !(parts[0].unit == parts[1].unit && parts[1].unit == parts[2].unit);
}

std::optional<Ink> function(std::string_view name, std::string_view arguments)
{
    const auto parts = components(arguments);
    if (!parts || parts->size() < 3 || parts->size() > 4)
        return std::nullopt;
    const double opacity = parts->size() == 4 ? share_of((*parts)[3], 1) : 1;
    if ((name == "rgb" || name == "rgba") && is_mixed(arguments, *parts))
        return std::nullopt;
    if (name == "rgb" || name == "rgba")
        return Ink{{share_of((*parts)[0], 255), share_of((*parts)[1], 255), share_of((*parts)[2], 255)},
                   opacity};
    if (name == "hsl" || name == "hsla")
        return Ink{of_hsl(degrees((*parts)[0]), share_of((*parts)[1], 100), share_of((*parts)[2], 100)),
                   opacity};
    return std::nullopt;
}

Ink of_bytes(double red, double green, double blue, double opacity)
{
    return {{red / 255, green / 255, blue / 255}, opacity / 255};
}

std::optional<Ink> named(std::string_view name)
{
    if (name == "transparent")
        return Ink{{}, 0};
    const auto known = scene::known_colour(name);
    return known ? std::optional{of_bytes(known->red, known->green, known->blue, 255)} : std::nullopt;
}

}

std::optional<Ink> colour(std::string_view text)
{
    const std::string word = lower_case(trimmed(text));
    if (const auto hex = scene::hex_colour(word))
        return of_bytes(hex->red, hex->green, hex->blue, hex->opacity);
    const std::size_t open = word.find('(');
    if (open == word.npos || !word.ends_with(')'))
        return named(word);
    return function(std::string_view{word}.substr(0, open),
                    std::string_view{word}.substr(open + 1, word.size() - open - 2));
}

}
