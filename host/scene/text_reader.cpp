#include "host/scene/text_reader.hpp"

#include "host/scene/font_reader.hpp"
#include "host/scene/limits.hpp"
#include "host/scene/property_rule.hpp"
#include "host/scene/spot_reader.hpp"
#include "host/scene/text_layout.hpp"
#include "host/scene/value_reader.hpp"
#include "host/text/glyph.hpp"

#include <cstdio>

namespace kfast::scene {
namespace {

constexpr std::array alignments{Word<Align>{"left", Align::left}, Word<Align>{"center", Align::center},
                                Word<Align>{"right", Align::right}};
constexpr Range sizes{1.0 / 16, extents.high};
constexpr Range spacings{-extents.high, extents.high};
constexpr double usual_leading = 1.2; ///< sizes
constexpr std::string_view usual_font = "hershey-sans";

/// What the properties of text give.
struct Properties {
    TextStyle style;
    std::string font{usual_font};
    std::optional<double> leading;
};

bool read_at(const kdl::Value& value, Properties& properties, Reading& reading)
{
    return assign(read_spot(value, reading), properties.style.at);
}

bool read_size(const kdl::Value& value, Properties& properties, Reading& reading)
{
    return assign(read_number(value, sizes, reading), properties.style.size);
}

bool read_font(const kdl::Value& value, Properties& properties, Reading& reading)
{
    properties.style.font = read_font(value, reading);
    if (properties.style.font != nullptr)
        properties.font = *value.string();
    return properties.style.font != nullptr;
}

bool read_align(const kdl::Value& value, Properties& properties, Reading& reading)
{
    return assign(read_word(value, alignments, reading), properties.style.align);
}

bool read_spacing(const kdl::Value& value, Properties& properties, Reading& reading)
{
    return assign(read_number(value, spacings, reading), properties.style.spacing);
}

bool read_leading(const kdl::Value& value, Properties& properties, Reading& reading)
{
    return assign(read_number(value, extents, reading), properties.leading);
}

constexpr std::array text_rules{
    PropertyRule<Properties>{"at", read_at, true},     PropertyRule<Properties>{"size", read_size, true},
    PropertyRule<Properties>{"font", read_font},       PropertyRule<Properties>{"align", read_align},
    PropertyRule<Properties>{"spacing", read_spacing}, PropertyRule<Properties>{"leading", read_leading},
};

std::optional<Properties> read_style(const kdl::Node& node, Reading& reading)
{
    Properties properties;
    if (!read_properties(node, text_rules, properties, reading))
        return std::nullopt;
    TextStyle& style = properties.style;
    if (style.font == nullptr)
        style.font = &reading.fonts.font(properties.font);
    style.leading = properties.leading.value_or(usual_leading * style.size);
    return properties;
}

/// The first character of `text` that `font` lacks.
std::optional<Place> first_missing(std::string_view text, Font& font)
{
    for (std::size_t at = 0; at < text.size();) {
        const CodePoint point = code_point_at(text, at);
        if (point.value != U'\n' && font.letter(point.value) == nullptr)
            return Place{at, point.length};
        at += point.length;
    }
    return std::nullopt;
}

/// As a reader and as Unicode names it, for it may be one that is not seen.
std::string in_words(std::string_view character)
{
    std::array<char, 16> code{};
    std::snprintf(code.data(), code.size(), " (U+%04X)",
                  static_cast<unsigned>(code_point_at(character, 0).value));
    return quoted(character) + code.data();
}

bool has_letters(const kdl::Value& value, std::string_view text, const Properties& properties,
                 Reading& reading)
{
    const auto missing = first_missing(text, *properties.style.font);
    if (!missing)
        return true;
    const std::string character = in_words(text.substr(missing->offset, missing->length));
    const Place place =
        value.text_offset ? Place{*value.text_offset + missing->offset, missing->length} : value.place;
    const bool bundled = properties.font.starts_with("hershey-");
    return reading.report.error(place, "the font " + quoted(properties.font) + " has no " + character,
                                bundled ? "it has those of ASCII; name a font file for others"
                                        : "name another font");
}

}

std::vector<Outline> read_text_shape(const kdl::Node& node, std::size_t points_left, Reading& reading)
{
    const kdl::Value& value = node.arguments.front();
    const auto properties = read_style(node, reading);
    const auto text = read_text(value, reading);
    if (!properties || !text || !has_letters(value, *text, *properties, reading))
        return {};
    auto outlines = set_text(*text, properties->style, points_left);
    if (!outlines)
        reading.report.error(value.place, too_many_points());
    else if (outlines->empty())
        reading.report.warning(value.place, "this text draws nothing");
    return std::move(outlines).value_or(std::vector<Outline>{});
}

}
