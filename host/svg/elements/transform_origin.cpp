#include "host/svg/elements/transform_origin.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace kfast::svg {
namespace {

using scene::Vec2;

std::vector<std::string_view> words(std::string_view text)
{
    std::vector<std::string_view> result;
    for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
        const std::size_t end = std::min(text.find_first_of(" \t\r\n,"), text.size());
        if (end > 0)
            result.push_back(text.substr(0, end));
        text = text.substr(std::min(std::max<std::size_t>(end, 1), text.size()));
    }
    return result;
}

struct Keyword {
    std::string_view name;
    double share;
};
constexpr std::array<Keyword, 5> keywords{
    {{"left", 0}, {"top", 0}, {"center", 0.5}, {"right", 1}, {"bottom", 1}}};

double along(std::string_view word, Axis axis, const Measure& measure)
{
    const auto keyword = std::ranges::find(keywords, word, &Keyword::name);
    if (keyword != keywords.end())
        return keyword->share * (axis == Axis::x ? measure.width : measure.height);
    return length(word, axis, measure).value_or(0);
}

std::optional<Vec2> origin(std::string_view text, const Measure& measure)
{
    auto parts = words(text);
    if (parts.empty())
        return std::nullopt;
    if (parts.size() == 1)
        parts.push_back("center");
    if (parts[0] == "top" || parts[0] == "bottom" || parts[1] == "left" || parts[1] == "right")
        std::swap(parts[0], parts[1]);
    return Vec2{along(parts[0], Axis::x, measure), along(parts[1], Axis::y, measure)};
}

art::Affine about(const art::Affine& affine, Vec2 origin)
{
    return art::moved(origin.x, origin.y) * affine * art::moved(-origin.x, -origin.y);
}

}

art::Affine about_origin(const art::Affine& affine, const Style& style, const Measure& measure)
{
    const auto found = origin(style["transform-origin"], measure);
    return found ? about(affine, *found) : affine;
}

bool turns_about_own_box(const Style& style)
{
    return style["transform-box"] == "fill-box" && !style["transform-origin"].empty();
}

art::Affine about_own_box(const Part& part, const Style& style)
{
    const auto box = box_of(part, {});
    if (!box)
        return part.own;
    const Vec2 size = box->max - box->min;
    const Vec2 inside = origin(style["transform-origin"], {size.x, size.y}).value_or(Vec2{});
    return about(part.own, box->min + inside);
}

double font_size(const Style& style, const Measure& outside)
{
    const auto size = length(style["font-size"], Axis::y, outside);
    return size && *size > 0 ? *size : outside.font_size;
}

}
