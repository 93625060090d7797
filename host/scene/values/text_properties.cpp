#include "host/scene/values/text_properties.hpp"

#include "host/kdl/document.hpp"
#include "host/program/failure.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/font/font_shelf.hpp"
#include "host/scene/values/geometry_reader.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/schema/node_form.hpp"
#include "host/schema/property_rule.hpp"
#include "host/text/characters.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

namespace kfast::scene {

namespace {

bool is_bundled(std::string_view name)
{
    return std::ranges::find(FontShelf::bundled_names(), name) != FontShelf::bundled_names().end();
}

/// The name of a file ends at U+0000.
bool names_file(std::string_view name)
{
    return name.find_first_of("./") != std::string_view::npos && name.find('\0') == std::string_view::npos;
}

bool leads_out(const std::filesystem::path& path)
{
    return path.is_absolute() || std::ranges::find(path, "..") != path.end();
}

/// Whether there may be a file of that name for this scene.
bool may_be_read(const kdl::Value& value, std::string_view name, SceneContext& context)
{
    if (!names_file(name))
        return context.report.error(value.place, "unknown font " + in_quotes(name),
                                    suggestion(name, FontShelf::bundled_names()) +
                                        " (a font file beside the scene is named as \"Sans.ttf\")");
    if (leads_out(name))
        return context.report.error(value.place, "a font file lies in the folder of the scene or below it",
                                    "copy it there, and write its path from there");
    return context.fonts.has_folder() ||
           context.report.error(value.place, "this scene is no file, so there are no files beside it",
                                suggestion("", FontShelf::bundled_names()));
}

/// The font that `value` names: a bundled one, or a file in the scene's folder or below it. Reports what is
/// wrong and then returns null.
Font* read_font(const kdl::Value& value, SceneContext& context)
{
    const auto name = read_text(value, context.report);
    if (!name || (!is_bundled(*name) && !may_be_read(value, *name, context)))
        return nullptr;
    try {
        return &context.fonts.font(std::string{*name});
    } catch (const Failure& failure) {
        context.report.error(value.place, visible(failure.what()));
        return nullptr;
    }
}

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

template <const kdl::Value* Properties::*kept>
bool keep_value(const kdl::Value& value, Properties& properties, SceneContext&)
{
    properties.*kept = &value;
    return true;
}

constexpr std::array vertical_alignments{Word<VerticalAlign>{"baseline", VerticalAlign::baseline},
                                         Word<VerticalAlign>{"top", VerticalAlign::top},
                                         Word<VerticalAlign>{"middle", VerticalAlign::middle},
                                         Word<VerticalAlign>{"bottom", VerticalAlign::bottom}};
constexpr Range starts{0, 1};

bool read_vertical(const kdl::Value& value, Properties& properties, SceneContext& context)
{
    return assign(read_word(value, vertical_alignments, context.report), properties.style.vertical);
}

bool read_along(const kdl::Value& value, Properties& properties, SceneContext& context)
{
    const auto path = read_followed_path(value, "a text", context);
    if (path)
        properties.style.along = std::make_shared<const PathRuler>(*path);
    return path.has_value();
}

bool read_start(const kdl::Value& value, Properties& properties, SceneContext& context)
{
    return assign(read_number(value, starts, context.report), properties.start);
}

constexpr PropertyRule<Properties> at_rule{"at", read_at, any_spot, true};
constexpr PropertyRule<Properties> vertical_rule{"vertical", read_vertical,
                                                 ValueKind::one_of<vertical_alignments>()};
constexpr std::array line_rules{
    PropertyRule<Properties>{"size", read_size, ValueKind::pixels(sizes), true},
    PropertyRule<Properties>{"font", read_font, any_font},
    PropertyRule<Properties>{"align", read_align, ValueKind::one_of<alignments>()},
    PropertyRule<Properties>{"spacing", read_spacing, ValueKind::pixels(spacings)},
};
constexpr auto fixed_rules = joined(
    std::array{at_rule}, line_rules,
    std::array{vertical_rule, PropertyRule<Properties>{"leading", read_leading, ValueKind::pixels(extents)}});
constexpr auto path_rules =
    joined(std::array{PropertyRule<Properties>{"along", read_along, any_path, true},
                      PropertyRule<Properties>{"start", read_start, ValueKind::number(starts)}},
           line_rules);
constexpr auto label_rules = joined(
    std::array{at_rule}, line_rules,
    std::array{vertical_rule, PropertyRule<Properties>{"input", keep_value<&Properties::input>, any_name},
               PropertyRule<Properties>{"format", keep_value<&Properties::format>, any_text}});

bool read_properties_of(TextKind kind, const kdl::Node& node, Properties& properties, SceneContext& context)
{
    switch (kind) {
    case TextKind::fixed:
        break;
    case TextKind::on_path:
        return read_properties(node, path_rules, properties, context);
    case TextKind::label:
        return read_properties(node, label_rules, properties, context);
    }
    return read_properties(node, fixed_rules, properties, context);
}

}

std::optional<TextProperties> read_text_properties(const kdl::Node& node, TextKind kind,
                                                   SceneContext& context)
{
    Properties properties;
    properties.font = FontShelf::bundled_names().front();
    if (!read_properties_of(kind, node, properties, context))
        return std::nullopt;
    TextStyle& style = properties.style;
    if (style.font == nullptr)
        style.font = &context.fonts.font(properties.font);
    style.leading = properties.leading.value_or(default_leading * style.size);
    if (style.along)
        style.start = properties.start * style.along->length();
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

std::vector<PropertySchema> text_property_schema(TextKind kind)
{
    switch (kind) {
    case TextKind::fixed:
        break;
    case TextKind::on_path:
        return schema_of(path_rules);
    case TextKind::label:
        return schema_of(label_rules);
    }
    return schema_of(fixed_rules);
}

}
