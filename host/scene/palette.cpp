#include "host/scene/palette.hpp"

#include "host/scene/limits.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <iterator>

namespace kfast::scene {
namespace {

struct BasicColour {
    std::string_view name;
    Colour colour;
};

constexpr std::array basic_colours{
    BasicColour{"black", {0, 0, 0}},       BasicColour{"silver", {192, 192, 192}},
    BasicColour{"gray", {128, 128, 128}},  BasicColour{"grey", {128, 128, 128}},
    BasicColour{"white", {255, 255, 255}}, BasicColour{"maroon", {128, 0, 0}},
    BasicColour{"red", {255, 0, 0}},       BasicColour{"purple", {128, 0, 128}},
    BasicColour{"fuchsia", {255, 0, 255}}, BasicColour{"green", {0, 128, 0}},
    BasicColour{"lime", {0, 255, 0}},      BasicColour{"olive", {128, 128, 0}},
    BasicColour{"yellow", {255, 255, 0}},  BasicColour{"navy", {0, 0, 128}},
    BasicColour{"blue", {0, 0, 255}},      BasicColour{"teal", {0, 128, 128}},
    BasicColour{"aqua", {0, 255, 255}},
};

constexpr std::uint8_t byte(std::uint32_t value) { return static_cast<std::uint8_t>(value & 0xFF); }

/// The last digit, twice.
constexpr std::uint8_t doubled(std::uint32_t value) { return byte((value & 15) * 17); }

}

std::optional<Colour> basic_colour(std::string_view name)
{
    const auto basic = std::ranges::find(basic_colours, name, &BasicColour::name);
    if (basic == basic_colours.end())
        return std::nullopt;
    return basic->colour;
}

std::optional<Colour> hex_colour(std::string_view text)
{
    const std::size_t digits = text.size() - 1;
    if (!text.starts_with('#') || (digits != 3 && digits != 4 && digits != 6 && digits != 8))
        return std::nullopt;
    std::uint32_t bits = 0;
    const char* const end = text.data() + text.size();
    if (std::from_chars(text.data() + 1, end, bits, 16).ptr != end)
        return std::nullopt;
    if (digits % 4 != 0)
        bits = digits == 3 ? bits << 4 | 15 : bits << 8 | 255;
    if (digits > 4)
        return Colour{byte(bits >> 24), byte(bits >> 16), byte(bits >> 8), byte(bits)};
    return Colour{doubled(bits >> 12), doubled(bits >> 8), doubled(bits >> 4), doubled(bits)};
}

std::optional<Place> Palette::declare(const std::string& name, Colour colour, Place place)
{
    const auto [entry, fresh] = named_.try_emplace(name, Named{colour, place});
    if (fresh)
        return std::nullopt;
    return entry->second.place;
}

std::optional<Colour> Palette::find(const std::string& text) const
{
    if (const auto entry = named_.find(text); entry != named_.end())
        return entry->second.colour;
    const auto basic = basic_colour(text);
    return basic ? basic : hex_colour(text);
}

std::optional<std::size_t> Palette::use(Colour colour)
{
    const auto entry = std::ranges::find(used_, colour);
    const auto index = static_cast<std::size_t>(entry - used_.begin());
    if (entry != used_.end())
        return index;
    if (used_.size() == most_colours)
        return std::nullopt;
    used_.push_back(colour);
    return index;
}

std::vector<std::string_view> Palette::names() const
{
    std::vector<std::string_view> names;
    for (const auto& [name, named] : named_)
        names.push_back(name);
    for (const BasicColour& basic : basic_colours)
        names.push_back(basic.name);
    return names;
}

std::vector<std::string_view> basic_colour_names()
{
    std::vector<std::string_view> names;
    std::ranges::transform(basic_colours, std::back_inserter(names), &BasicColour::name);
    return names;
}

}
