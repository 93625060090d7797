#pragma once

#include "core/scene/input_view.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace kfast {

/// The value of an input from its text, in 1/1000; nothing if it is no number within the range.
std::optional<std::int32_t> read_input_value(std::string_view text, const InputView& input);

/// What is wrong with it then.
std::string input_value_mistake(std::string_view text, const InputView& input);

/// What is wrong with a text for the input `name` of at most `max` characters, which are `glyphs` if they are
/// known. Nothing if it is valid.
std::optional<std::string> input_text_mistake(std::string_view text, std::string_view name, std::size_t max,
                                              const std::optional<GlyphSet>& glyphs);

}
