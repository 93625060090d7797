#pragma once

#include <cstdint>
#include <string>

namespace kfast {

/// A speed in 1/65536 of the authored one, from a factor: "0.5", "-1". Throws CLI::ValidationError in the
/// name of `option`.
std::int32_t read_speed(const std::string& option, const std::string& text);

}
