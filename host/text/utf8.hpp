#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace kfast {

/// One code point as it stands in a text. A byte that begins no valid UTF-8 sequence is a code point of its
/// own, with `valid` false and its own value.
struct CodePoint {
    char32_t value = 0;
    std::size_t length = 1; ///< in bytes, at least 1
    bool valid = true;
};

/// The code point at `offset`, which must lie inside the text. Overlong forms, surrogates and values above
/// U+10FFFF are invalid.
CodePoint code_point_at(std::string_view text, std::size_t offset);

/// Whether a code point can be written in UTF-8 at all: not a surrogate and not above U+10FFFF.
bool is_scalar_value(char32_t value);

/// `value` must be a scalar value.
void append_utf8(std::string& text, char32_t value);

}
