#include "host/scene_text/values/colours.hpp"

#include "host/scene/context/limits.hpp"
#include "host/scene/context/palette.hpp"
#include "host/scene_text/values/nodes.hpp"

#include <algorithm>
#include <cmath>

namespace kfast::scene_text {
namespace {

std::uint8_t channel(double share)
{
    return static_cast<std::uint8_t>(std::lround(std::clamp(share, 0.0, 1.0) * 255));
}

std::string hex(Colour colour)
{
    constexpr std::string_view digits = "0123456789abcdef";
    std::string text = "#";
    for (const std::uint8_t byte : {colour.red, colour.green, colour.blue, colour.opacity})
        text += {digits[byte >> 4], digits[byte & 15]};
    return colour.opacity == 255 ? text.substr(0, 7) : text;
}

int distance(Colour left, Colour right)
{
    const auto square = [](int one, int other) { return (one - other) * (one - other); };
    return square(left.red, right.red) + square(left.green, right.green) + square(left.blue, right.blue) +
           square(left.opacity, right.opacity);
}

}

Colour stored_colour(const art::Rgb& colour, double opacity)
{
    return {channel(colour.red), channel(colour.green), channel(colour.blue), channel(opacity)};
}

Colours::Colours(art::Losses& losses) : losses_{losses}
{
    // A palette that calls something else by the name of a known colour would mislead.
    for (const std::string_view name : scene::known_colour_names())
        names_.reserve(name);
}

std::string Colours::word(Colour colour, std::string_view user)
{
    const auto known = std::ranges::find(entries_, colour, &Entry::colour);
    if (known != entries_.end())
        return known->name;
    // The background, if there is none, is black, and a colour in use.
    if (entries_.size() + 1 >= scene::max_colours) {
        losses_.add(
            {"more than " + std::to_string(scene::max_colours) + " colours", "", {}, "the nearest of them"});
        return nearest(colour).name;
    }
    const bool is_black = colour == Colour{0, 0, 0, 255};
    const bool is_known = is_black || colour == Colour{255, 255, 255, 255};
    entries_.push_back(
        {colour, is_known ? (is_black ? "black" : "white") : names_.unique(user, "colour"), is_known});
    return entries_.back().name;
}

const Colours::Entry& Colours::nearest(Colour colour) const
{
    return *std::ranges::min_element(entries_, {},
                                     [&](const Entry& entry) { return distance(entry.colour, colour); });
}

std::vector<kdl::Node> Colours::nodes() const
{
    kdl::Node palette = named_node("palette");
    for (const Entry& entry : entries_)
        if (!entry.is_known)
            palette.children.push_back(named_node(entry.name, text(hex(entry.colour))));
    if (palette.children.empty())
        return {};
    return {palette};
}

}
