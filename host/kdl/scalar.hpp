#pragma once

#include "host/kdl/document.hpp"
#include "host/kdl/scanner.hpp"

#include <string_view>

namespace kfast::kdl {

/// true, false, null, inf, -inf and nan are reserved: they would be mistaken for #true and so on.
bool is_reserved(std::string_view word);

/// Whether a word begins like a number, as 12, -3x and .5 do.
bool begins_like_number(std::string_view word);

/// Whether `text` may be written without quotes.
bool is_identifier(std::string_view text);

/// Whether a string, a number or a keyword comes next, valid or not.
bool at_scalar(const Scanner& scanner);

/// At a scalar: goes over it and sets the data and the text offset of `value`. Errors are reported, and false
/// returned.
bool read_scalar(Scanner& scanner, Value& value);

}
