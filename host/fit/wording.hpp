#pragma once

#include "core/time/time.hpp"
#include "host/fit/scene_needs.hpp"

#include <cstddef>
#include <string>
#include <string_view>

/// Numbers as a fit report prints them.
namespace kfast::fit {

std::string bytes_text(std::size_t bytes);
/// With few digits: "310 B", "4.8 KiB", "1.75 MiB"
std::string memory_text(std::size_t bytes);
/// In frames: "37", "37.5"
std::string frame_text(Time moment);
/// "12.3 ms"
std::string milliseconds_text(double seconds);
/// Why a picture that takes so long to compute does not fit the board. Empty if its watchdog allows that.
std::string watchdog_reason(double seconds, Time moment, const Target& target);
/// "30 fps", "24.4 fps"; rounded down. "more than 1000 fps" for all that no panel shows.
std::string rate_text(double per_second);
/// "62.5 MHz", "400 kHz"
std::string frequency_text(double hertz);

/// "player 14000, scene 426": the parts that are not zero.
std::string parts_text(const FlashNeed& need);
/// `buffers` is the name of the two of them.
std::string parts_text(const RamNeed& need, std::string_view buffers);

/// The firmware's part of a chip, whatever the scene: "1.75 MiB of 2 MiB of flash: player 61.2 KiB,
/// slots 1.5 MiB".
std::string firmware_flash_text(const FlashNeed& need, const Target& target);
std::string firmware_ram_text(const RamNeed& need, const Target& target, std::string_view buffers);

}
