#include "host/scene/context/palette.hpp"

#include "host/scene/context/colour_names.hpp"
#include "host/scene/context/limits.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <iterator>

namespace kfast::scene {
namespace {

/// Those of the known names that were in the first version of CSS.
constexpr std::array<std::string_view, 16> first_names{
    "black", "silver", "gray",  "white",  "maroon", "red",  "purple", "fuchsia",
    "green", "lime",   "olive", "yellow", "navy",   "blue", "teal",   "aqua"};

constexpr std::uint8_t byte(std::uint32_t value) { return static_cast<std::uint8_t>(value & 0xFF); }

/// The last digit, twice.
constexpr std::uint8_t doubled(std::uint32_t value) { return byte((value & 15) * 17); }

}

std::optional<Colour> known_colour(std::string_view name)
{
    const auto known = std::ranges::lower_bound(colour_names, name, {}, &NamedColour::name);
    if (known == colour_names.end() || known->name != name)
        return std::nullopt;
    return Colour{byte(known->rgb >> 16), byte(known->rgb >> 8), byte(known->rgb)};
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

std::optional<SourceSpan> Palette::declare(const std::string& name, Colour colour, SourceSpan place)
{
    const auto [entry, fresh] = named_.try_emplace(name, Named{colour, place});
    if (!fresh)
        return entry->second.place;
    in_order_.push_back(colour);
    return std::nullopt;
}

std::optional<Colour> Palette::find(const std::string& text) const
{
    if (const auto entry = named_.find(text); entry != named_.end())
        return entry->second.colour;
    const auto known = known_colour(text);
    return known ? known : hex_colour(text);
}

std::optional<std::size_t> Palette::use(Colour colour)
{
    const auto entry = std::ranges::find(used_, colour);
    const auto index = static_cast<std::size_t>(entry - used_.begin());
    if (entry != used_.end())
        return index;
    if (used_.size() == max_colours)
        return std::nullopt;
    used_.push_back(colour);
    return index;
}

bool Palette::use_declared()
{
    return std::ranges::all_of(in_order_, [this](Colour colour) { return use(colour).has_value(); });
}

bool Palette::is_declared(std::size_t index) const
{
    return std::ranges::find(in_order_, used_[index]) != in_order_.end();
}

std::size_t Palette::behind(std::size_t index, int steps) const
{
    const auto own = std::ranges::find(in_order_, used_[index]);
    if (own == in_order_.end())
        return index;
    const auto count = static_cast<std::ptrdiff_t>(in_order_.size());
    const std::ptrdiff_t place = (own - in_order_.begin() + steps) % count;
    const Colour colour = in_order_[static_cast<std::size_t>(place < 0 ? place + count : place)];
    return static_cast<std::size_t>(std::ranges::find(used_, colour) - used_.begin());
}

std::vector<std::string_view> Palette::declared_names() const
{
    std::vector<std::string_view> names;
    for (const auto& [name, named] : named_)
        names.push_back(name);
    return names;
}

std::vector<std::string_view> Palette::names() const
{
    std::vector<std::string_view> names = declared_names();
    std::ranges::transform(colour_names, std::back_inserter(names), &NamedColour::name);
    return names;
}

std::vector<std::string_view> Palette::common_names() const
{
    std::vector<std::string_view> names = declared_names();
    std::ranges::copy(first_names, std::back_inserter(names));
    return names;
}

std::vector<std::string_view> known_colour_names()
{
    std::vector<std::string_view> names;
    std::ranges::transform(colour_names, std::back_inserter(names), &NamedColour::name);
    return names;
}

}
