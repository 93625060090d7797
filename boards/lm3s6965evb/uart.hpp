#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

/// UART0: 115200 baud, 8 bits, no parity. Writing waits for room.
namespace kfast::lm3s6965evb::uart {

void begin();
void write(char letter);
void write(const char* text);
void write(std::string_view text);
void write_decimal(std::uint32_t number);
/// Eight digits.
void write_hex(std::uint32_t number);

/// Whether read() has a byte to give.
bool pending();
/// Waits for a byte.
char read();

}
