#pragma once

#include "host/text/utf8.hpp"

#include <cstddef>
#include <string>
#include <string_view>

namespace kfast {

/// A code point as it may be sent to a terminal, and the columns it takes there.
struct Glyph {
    std::string text;
    std::size_t columns = 1;
};

/// Controls, text direction marks and invalid bytes come out as <U+001B> or <0xFF>; a tab as four spaces.
Glyph glyph(CodePoint point);

/// `text` with every code point as its glyph, line ends included.
std::string visible(std::string_view text);

/// `text` for a message: visible, in quotes, and cut with … when it is long.
std::string in_quotes(std::string_view text);

}
