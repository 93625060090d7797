#pragma once

#include "core/math/point.hpp"
#include "core/time/time.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace kfast {

/// "240x135", with sides that a panel can have. Throws CLI::ValidationError in the name of `option`.
Size read_size(const std::string& option, const std::string& text);

/// "240x135"
std::string size_text(Size size);

/// A time as written on the command line: "1.5s", "500ms", or a number of frames such as "12.5"; rounded
/// once, to the nearest tick. None when it is no such text, negative, or beyond what Time holds.
/// `frame_rate` is in frames per 1000 seconds.
std::optional<Time> read_time(std::string_view text, std::uint32_t frame_rate);

/// A speed in 1/65536 of the authored one, from a factor: "0.5", "-1". Throws CLI::ValidationError in the
/// name of `option`.
std::int32_t read_speed(const std::string& option, const std::string& text);

/// Hz, from "40MHz", "400kHz" or "9600Hz". Throws CLI::ValidationError in the name of `option`.
std::uint32_t read_clock(const std::string& option, const std::string& text);

/// With as few digits as are exact: "62.5 MHz"
std::string clock_text(std::uint32_t hz);

/// "0" to "255", or "40%". Throws CLI::ValidationError in the name of `option`.
std::uint8_t read_brightness(const std::string& option, const std::string& text);

}
