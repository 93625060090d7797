#pragma once

#include "core/bytes/code_point.hpp"

#include <cstddef>
#include <string>
#include <string_view>

namespace kfast {

/// `value` must be a scalar value.
void append_utf8(std::string& text, char32_t value);

/// Whether a byte of UTF-8 is one behind the first of a code point.
constexpr bool continues_sequence(char byte) { return (static_cast<unsigned char>(byte) & 0xC0) == 0x80; }

/// The character that a text in UTF-16 begins with, after a byte order mark, if it is one of ASCII; else 0.
/// Without a mark, a text is taken as UTF-16 if its first character is one that texts begin with: printable,
/// a space, a tab or the end of a line.
char first_of_utf16(std::string_view text);

/// Whether it has a byte order mark of UTF-16, or begins as such a text does.
bool seems_utf16(std::string_view text);

/// A code point as it may be sent to a terminal, and the columns it takes there.
struct Glyph {
    std::string text;
    std::size_t columns = 1;
};

/// Whether a terminal only shows it: no control, no mark of the direction of a text, and nothing unseen.
bool is_printable(char32_t value);

/// What is not printable and invalid bytes are shown as <U+001B> or <0xFF>; a tab as four spaces.
Glyph glyph(CodePoint point);

/// `text` with every code point as its glyph, line ends included.
std::string visible(std::string_view text);

/// `json`, a text in UTF-8 whose controls but line ends are escaped already, with all else that is not
/// printable escaped: "\u202e". It means the same.
std::string printable_json(std::string_view json);

/// `text` for a message: visible, in quotes, and truncated with … when it is long.
std::string in_quotes(std::string_view text);

}
