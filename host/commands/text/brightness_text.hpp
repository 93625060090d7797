#pragma once

#include <cstdint>
#include <string>

namespace kfast {

/// "0" to "255", or "40%". Throws CLI::ValidationError in the name of `option`.
std::uint8_t read_brightness(const std::string& option, const std::string& text);

}
