#include "host/scene/text_properties.hpp"

#include "host/scene/font_reader.hpp"
#include "host/scene/node_words.hpp"
#include "host/scene/property_rule.hpp"
#include "host/scene/spot_reader.hpp"
#include "host/scene/value_reader.hpp"
#include "host/text/glyph.hpp"

#include <array>
#include <cstdio>

namespace kfast::scene {
namespace {

using Properties = TextProperties;

constexpr std::array alignments{Word<Align>{"left", Align::left}, Word<Align>{"center", Align::center},
                                Word<Align>{"right", Align::right}};
constexpr Range sizes{1.0 / 16, extents.high};
constexpr Range spacings{-extents.high, extents.high};
constexpr double default_leading = 1.2; ///< sizes

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

bool keep_input(const kdl::Value& value, Properties& properties, Reading&)
{
    properties.input = &value;
    return true;
}

constexpr std::array line_rules{
    PropertyRule<Properties>{"at", read_at, any_spot, true},
    PropertyRule<Properties>{"size", read_size, ValueKind::pixels(sizes), true},
    PropertyRule<Properties>{"font", read_font, any_font},
    PropertyRule<Properties>{"align", read_align, ValueKind::one_of<alignments>()},
    PropertyRule<Properties>{"spacing", read_spacing, ValueKind::pixels(spacings)},
};
constexpr auto fixed_rules = joined(
    line_rules, std::array{PropertyRule<Properties>{"leading", read_leading, ValueKind::pixels(extents)}});
constexpr auto label_rules =
    joined(line_rules, std::array{PropertyRule<Properties>{"input", keep_input, any_name}});

}

std::optional<TextProperties> read_text_properties(const kdl::Node& node, TextKind kind, Reading& reading)
{
    Properties properties{
        .style = {}, .font = std::string{FontShelf::bundled_names().front()}, .leading = {}};
    const bool good = kind == TextKind::fixed ? read_properties(node, fixed_rules, properties, reading)
                                              : read_properties(node, label_rules, properties, reading);
    if (!good)
        return std::nullopt;
    TextStyle& style = properties.style;
    if (style.font == nullptr)
        style.font = &reading.fonts.font(properties.font);
    style.leading = properties.leading.value_or(default_leading * style.size);
    return properties;
}

std::string in_words(std::string_view character)
{
    std::array<char, 16> code{};
    std::snprintf(code.data(), code.size(), " (U+%04X)",
                  static_cast<unsigned>(code_point_at(character, 0).value));
    return in_quotes(character) + code.data();
}

std::string other_font(char32_t character, Reading& reading)
{
    const std::vector<std::string_view> fonts = reading.fonts.bundled_with(character);
    if (fonts.empty())
        return "no bundled font has it: name a font file beside the scene";
    std::string remedy = "write font=";
    for (const std::string_view& font : fonts)
        remedy.append(&font == &fonts.front() ? "" : &font == &fonts.back() ? " or " : ", ").append(font);
    return remedy;
}

void note_lines(const TextProperties& properties, Place place, Reading& reading)
{
    if (properties.style.font->has_lines() && !reading.line_letters)
        reading.line_letters = LineLetters{properties.font, place};
}

std::vector<PropertyWords> text_property_words(TextKind kind)
{
    return kind == TextKind::fixed ? words_of(fixed_rules) : words_of(label_rules);
}

}
