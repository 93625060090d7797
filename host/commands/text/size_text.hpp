#pragma once

#include "core/math/point.hpp"

#include <string>

namespace kfast {

/// "240x135", with sides that a panel can have. Throws CLI::ValidationError in the name of `option`.
Size read_size(const std::string& option, const std::string& text);

/// "240x135"
std::string size_text(Size size);

}
