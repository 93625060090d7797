#pragma once

#include "firmware/board_settings.hpp"

#include <cstdint>
#include <string_view>

/// What the board tells to a serial terminal: lines at 115200 baud, 8 bits, no parity, sent while the program
/// goes on. A line is told when its '\n' is written; one that the buffer has no room for is lost whole.
namespace kfast::pico::log {

/// Needs start_clocks(). Nothing is told if the pin cannot send.
void begin(Pin pin);
/// Whether anybody is told anything.
bool is_on();

void write(char letter);
void write(const char* text);
void write(std::string_view text);
void write_decimal(std::uint32_t number);
/// Eight digits.
void write_hex(std::uint32_t number);

/// Waits until all lines have been sent; with interrupts off as well.
void send_waiting();

}
