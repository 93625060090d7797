#include "host/scene/values/text_properties.hpp"

#include "host/scene/values/font_reader.hpp"
#include "host/scene/values/spot_reader.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/schema/node_schema.hpp"
#include "host/schema/property_rule.hpp"
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

bool read_at(const kdl::Value& value, Properties& properties, SceneContext& context)
{
    return assign(read_spot(value, context), properties.style.at);
}

bool read_size(const kdl::Value& value, Properties& properties, SceneContext& context)
{
    return assign(read_number(value, sizes, context.report), properties.style.size);
}

bool read_font(const kdl::Value& value, Properties& properties, SceneContext& context)
{
    properties.style.font = read_font(value, context);
    if (properties.style.font != nullptr)
        properties.font = *value.string();
    return properties.style.font != nullptr;
}

bool read_align(const kdl::Value& value, Properties& properties, SceneContext& context)
{
    return assign(read_word(value, alignments, context.report), properties.style.align);
}

bool read_spacing(const kdl::Value& value, Properties& properties, SceneContext& context)
{
    return assign(read_number(value, spacings, context.report), properties.style.spacing);
}

bool read_leading(const kdl::Value& value, Properties& properties, SceneContext& context)
{
    return assign(read_number(value, extents, context.report), properties.leading);
}

bool keep_input(const kdl::Value& value, Properties& properties, SceneContext&)
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

std::optional<TextProperties> read_text_properties(const kdl::Node& node, TextKind kind,
                                                   SceneContext& context)
{
    Properties properties{
        .style = {}, .font = std::string{FontShelf::bundled_names().front()}, .leading = {}};
    const bool good = kind == TextKind::fixed ? read_properties(node, fixed_rules, properties, context)
                                              : read_properties(node, label_rules, properties, context);
    if (!good)
        return std::nullopt;
    TextStyle& style = properties.style;
    if (style.font == nullptr)
        style.font = &context.fonts.font(properties.font);
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

std::string other_font(char32_t character, SceneContext& context)
{
    const std::vector<std::string_view> fonts = context.fonts.bundled_with(character);
    if (fonts.empty())
        return "no bundled font has it: name a font file beside the scene";
    std::string hint = "write font=";
    for (const std::string_view& font : fonts)
        hint.append(&font == &fonts.front() ? "" : &font == &fonts.back() ? " or " : ", ").append(font);
    return hint;
}

void note_lines(const TextProperties& properties, SourceSpan place, SceneContext& context)
{
    if (properties.style.font->has_lines() && !context.line_letters)
        context.line_letters = LineLetters{properties.font, place};
}

std::vector<PropertySchema> text_property_words(TextKind kind)
{
    return kind == TextKind::fixed ? words_of(fixed_rules) : words_of(label_rules);
}

}
