#pragma once

#include <cstddef>
#include <string_view>

namespace kfast {

/// One code point as it is in a text. A byte that begins no valid UTF-8 sequence is a code point of its
/// own, with `valid` false and its own value.
struct CodePoint {
    char32_t value = 0;
    std::size_t length = 1; ///< in bytes, at least 1
    bool valid = true;
};

inline constexpr char32_t last_code_point = 0x10FFFF;

/// The code point at `offset`, which must be inside the text. Overlong forms, surrogates and values above
/// U+10FFFF are invalid.
CodePoint code_point_at(std::string_view text, std::size_t offset);

/// Whether a code point can be written in UTF-8 at all: not a surrogate and not above U+10FFFF.
constexpr bool is_scalar_value(char32_t value)
{
    return value < 0xD800 || (value > 0xDFFF && value <= last_code_point);
}

}
