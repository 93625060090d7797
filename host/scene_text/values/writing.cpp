#include "host/scene_text/values/writing.hpp"

#include "core/bytes/code_point.hpp"
#include "core/scene/kfb_limits.hpp"
#include "host/kdl/scanner.hpp"
#include "host/scene/context/limits.hpp"
#include "host/scene/context/palette.hpp"
#include "host/scene_text/values/nodes.hpp"
#include "host/words/scene_words.hpp"

#include <algorithm>
#include <cmath>

namespace kfast::scene_text {

namespace {

constexpr std::size_t longest = kfb::max_name_bytes;

bool may_stand(CodePoint point)
{
    return point.valid && point.value >= 0x20 && point.value != 0x7F && !kdl::is_disallowed(point.value) &&
           !kdl::is_newline(point.value);
}

/// Not in the middle of a code point.
std::string_view cut(std::string_view name, std::size_t bytes)
{
    std::size_t end = 0;
    while (end < name.size()) {
        const std::size_t next = end + code_point_at(name, end).length;
        if (next > bytes)
            break;
        end = next;
    }
    return name.substr(0, end);
}

std::string_view trimmed(std::string_view name)
{
    const std::size_t begin = std::min(name.find_first_not_of(' '), name.size());
    const std::size_t end = name.find_last_not_of(' ');
    return end == std::string_view::npos ? std::string_view{} : name.substr(begin, end - begin + 1);
}

}

std::string clean_name(std::string_view name, std::string_view default_value)
{
    std::string clean;
    for (std::size_t at = 0; at < name.size();) {
        const CodePoint point = code_point_at(name, at);
        clean += may_stand(point) ? std::string{name.substr(at, point.length)} : " ";
        at += point.length;
    }
    const std::string_view kept = trimmed(cut(trimmed(clean), longest));
    return std::string{kept.empty() ? default_value : kept};
}

kdl::Value loop_word(Loop loop) { return text(std::string{loop_name(loop)}); }

std::string Names::unique(std::string_view name, std::string_view default_value)
{
    std::string clean = clean_name(name, default_value);
    if (taken_.insert(clean).second)
        return clean;
    std::size_t& count = counts_.try_emplace(clean, 1).first->second;
    while (true) {
        const std::string number = '-' + std::to_string(++count);
        std::string numbered = std::string{cut(clean, longest - number.size())} + number;
        if (taken_.insert(numbered).second)
            return numbered;
    }
}

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
