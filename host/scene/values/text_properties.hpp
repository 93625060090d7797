#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/font/text_layout.hpp"
#include "host/schema/node_form.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace kfast::scene {

/// What the properties of a text give.
struct TextProperties {
    TextStyle style;
    std::string font;
    std::optional<double> leading;
    double start = 0;                   ///< share of the length of the path
    const kdl::Value* input = nullptr;  ///< the name of one
    const kdl::Value* format = nullptr; ///< of a number
};

enum class TextKind : std::uint8_t {
    fixed,   ///< its words are written
    on_path, ///< they are, and run along a path
    label,   ///< its words are those of an input, on one line
};

/// Reads the properties. Nothing when they are wrong, which is reported.
std::optional<TextProperties> read_text_properties(const kdl::Node& node, TextKind kind,
                                                   SceneContext& context);

/// A character and its Unicode number, because it may be invisible: "\"ß\" (U+00DF)".
std::string in_words(std::string_view character);

/// What to do when a font lacks `character`: names the bundled fonts that have it.
std::string other_font(char32_t character, SceneContext& context);

/// Remembers a text whose letters are lines: the object that draws it may have no stroke.
void note_lines(const TextProperties& properties, SourceSpan place, SceneContext& context);

std::vector<PropertySchema> text_property_schema(TextKind kind);

}
