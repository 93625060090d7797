#include "host/svg/markup/transform_list.hpp"

#include "host/geometry/path_scanner.hpp"
#include "host/svg/markup/length.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace kfast::svg {
namespace {

using art::Affine;
using Values = std::vector<double>;

double tangent(double degrees) { return std::tan(degrees * std::numbers::pi / 180); }

Affine skewed(double along_x, double along_y) { return {1, tangent(along_y), tangent(along_x), 1, 0, 0}; }

Affine rotate(const Values& v)
{
    if (v.size() == 1)
        return art::turned(v[0]);
    return art::moved(v[1], v[2]) * art::turned(v[0]) * art::moved(-v[1], -v[2]);
}

struct Kind {
    std::string_view name;
    std::size_t min; ///< values; or `max`, and, except for "rotate", nothing between
    std::size_t max;
    Affine (*matrix)(const Values&);
};

double second(const Values& v, double default_value) { return v.size() > 1 ? v[1] : default_value; }

constexpr std::array<Kind, 11> kinds{{
    {"matrix", 6, 6, [](const Values& v) { return Affine{v[0], v[1], v[2], v[3], v[4], v[5]}; }},
    {"translate", 1, 2, [](const Values& v) { return art::moved(v[0], second(v, 0)); }},
    {"translateX", 1, 1, [](const Values& v) { return art::moved(v[0], 0); }},
    {"translateY", 1, 1, [](const Values& v) { return art::moved(0, v[0]); }},
    {"scale", 1, 2, [](const Values& v) { return art::grown(v[0], second(v, v[0])); }},
    {"scaleX", 1, 1, [](const Values& v) { return art::grown(v[0], 1); }},
    {"scaleY", 1, 1, [](const Values& v) { return art::grown(1, v[0]); }},
    {"rotate", 1, 3, rotate},
    {"skew", 1, 2, [](const Values& v) { return skewed(v[0], second(v, 0)); }},
    {"skewX", 1, 1, [](const Values& v) { return skewed(v[0], 0); }},
    {"skewY", 1, 1, [](const Values& v) { return skewed(0, v[0]); }},
}};

struct AngleUnit {
    std::string_view name;
    double degrees;
};
constexpr std::array<AngleUnit, 4> angle_units{
    {{"deg", 1}, {"rad", 180 / std::numbers::pi}, {"grad", 0.9}, {"turn", 360}}};

/// A number, an angle in degrees or a length in pixels.
std::optional<double> value(std::string_view text)
{
    scene::PathScanner scanner{text};
    const auto angle = scanner.number();
    if (!angle)
        return std::nullopt;
    const auto unit = std::ranges::find(angle_units, text.substr(scanner.offset()), &AngleUnit::name);
    if (unit != angle_units.end())
        return *angle * unit->degrees;
    return text.ends_with('%') ? std::nullopt : length(text, Axis::x, {});
}

/// Between the parentheses.
std::optional<Values> values(std::string_view text)
{
    Values result;
    for (text = trimmed(text); !text.empty();) {
        scene::PathScanner scanner{text};
        if (!scanner.number())
            return std::nullopt;
        std::size_t end = scanner.offset();
        while (end < text.size() &&
               (std::isalpha(static_cast<unsigned char>(text[end])) != 0 || text[end] == '%'))
            ++end;
        const auto read = value(text.substr(0, end));
        if (!read)
            return std::nullopt;
        result.push_back(*read);
        text = trimmed(text.substr(end));
        if (text.starts_with(','))
            text = trimmed(text.substr(1));
    }
    return result;
}

std::optional<Affine> one(std::string_view name, std::string_view arguments)
{
    const auto kind = std::ranges::find(kinds, name, &Kind::name);
    const auto read = values(arguments);
    if (kind == kinds.end() || !read || read->size() < kind->min || read->size() > kind->max)
        return std::nullopt;
    if (name == "rotate" && read->size() == 2)
        return std::nullopt;
    return kind->matrix(*read);
}

}

std::optional<Affine> transform_list(std::string_view text)
{
    Affine result;
    for (text = trimmed(text); !text.empty() && text != "none";) {
        const std::size_t open = text.find('(');
        const std::size_t close = text.find(')');
        if (open == text.npos || close == text.npos || close < open)
            return std::nullopt;
        const auto next = one(trimmed(text.substr(0, open)), text.substr(open + 1, close - open - 1));
        if (!next)
            return std::nullopt;
        result = result * *next;
        text = trimmed(text.substr(close + 1));
        if (text.starts_with(','))
            text = trimmed(text.substr(1));
    }
    return result;
}

}
