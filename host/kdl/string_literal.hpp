#pragma once

#include "host/kdl/scanner.hpp"

#include <cstddef>
#include <optional>
#include <string>

namespace kfast::kdl {

struct StringLiteral {
    std::string text;
    std::optional<std::size_t> text_offset; ///< as Value::text_offset
};

/// Whether quotes come next, or the # and quotes of a raw string.
bool at_string_literal(const Scanner& scanner);

/// At a string literal: goes over it. Errors are reported and leave nothing.
std::optional<StringLiteral> read_string_literal(Scanner& scanner);

}
