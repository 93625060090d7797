#pragma once

#include "core/bytes/code_point.hpp"

#include <string>

namespace kfast {

/// `value` must be a scalar value.
void append_utf8(std::string& text, char32_t value);

}
