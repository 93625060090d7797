#pragma once

#include <string_view>

namespace kfast::kdl {

/// true, false, null, inf, -inf and nan are reserved: they would be mistaken for #true and so on.
bool is_reserved(std::string_view word);

/// Whether a word begins like a number, as 12, -3x and .5 do.
bool begins_like_number(std::string_view word);

/// Whether `text` may be written without quotes.
bool is_identifier(std::string_view text);

}
