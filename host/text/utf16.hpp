#pragma once

#include <string_view>

namespace kfast {

/// The character that a text in UTF-16 begins with, behind a byte order mark, if it is one of ASCII; else 0.
/// Without a mark, a text is taken for UTF-16 if its first character is one that texts begin with: printed, a
/// space, a tab or the end of a line.
char first_of_utf16(std::string_view text);

/// Whether it has a byte order mark of UTF-16, or begins as such a text does.
bool seems_utf16(std::string_view text);

}
