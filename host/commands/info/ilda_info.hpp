#pragma once

#include <cstdint>
#include <string>

namespace kfast {

/// Whether a file begins as ILDA files do; false if it cannot be read.
bool is_ilda(const std::string& path);

/// Prints what kfast info shows of one, played with `rate` points a second. Throws Failure for a file that
/// cannot be read or is wrong.
void print_ilda_info(const std::string& path, std::uint32_t rate, bool as_json);

}
