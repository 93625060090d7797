#pragma once

#include "core/time/time.hpp"

#include <cstdint>
#include <optional>
#include <string_view>

namespace kfast {

/// A moment as written on the command line: "1.5s", "500ms", or a number of frames such as "12.5"; rounded
/// once, to the nearest tick. None when it is no such text, negative, or beyond what Time holds.
/// `frame_rate` is in frames per 1000 seconds.
std::optional<Time> read_time(std::string_view text, std::uint32_t frame_rate);

}
