#pragma once

#include "host/kdl/scanner.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace kfast::kdl {

/// After the opening """ of a string that began at `begin` with `hashes` (none if it is not raw): goes over
/// it and returns its text without the indentation that all lines share. Errors are reported and leave
/// nothing.
std::optional<std::string> read_multi_line_string(Scanner& scanner, std::size_t begin,
                                                  std::string_view hashes);

}
