#pragma once

#include <cstdint>
#include <string>

namespace kfast {

/// Hz, from "40MHz", "400kHz" or "9600Hz". Throws CLI::ValidationError in the name of `option`.
std::uint32_t read_clock(const std::string& option, const std::string& text);

/// As few digits as tell it: "62.5 MHz"
std::string clock_text(std::uint32_t hz);

}
