#include "boards/lm3s6965evb/uart.hpp"

#include "boards/lm3s6965evb/clocks.hpp"
#include "boards/lm3s6965evb/registers.hpp"

namespace kfast::lm3s6965evb::uart {
namespace {

// The divisor system_hz / (16 x baud) in 1/64, rounded: 1736, that is 27 + 8/64.
constexpr std::uint32_t baud = 115'200;
constexpr std::uint32_t divisor = (system_hz * 4 + baud / 2) / baud;
static_assert(divisor / 64 == 27 && divisor % 64 == 8);

constexpr std::uint32_t receive_empty = 1 << 4;
constexpr std::uint32_t transmit_full = 1 << 5;

}

void begin()
{
    gpio_a_afsel.set(0x03);
    gpio_a_den.set(0x03);
    uart_ctl.write(0);
    uart_ibrd.write(divisor / 64);
    uart_fbrd.write(divisor % 64);
    uart_lcrh.write(0x70); // 8 bits, FIFO on
    uart_ctl.write(0x301); // receiver, transmitter, on
}

void write(char letter)
{
    while ((uart_fr.read() & transmit_full) != 0) {
    }
    uart_dr.write(static_cast<std::uint8_t>(letter));
}

void write(const char* text)
{
    for (; *text != 0; ++text)
        write(*text);
}

void write(std::string_view text)
{
    for (const char letter : text)
        write(letter);
}

void write_decimal(std::uint32_t number)
{
    if (number >= 10)
        write_decimal(number / 10);
    write(static_cast<char>('0' + number % 10));
}

void write_hex(std::uint32_t number)
{
    for (int shift = 28; shift >= 0; shift -= 4)
        write("0123456789abcdef"[number >> shift & 15]);
}

bool pending() { return (uart_fr.read() & receive_empty) == 0; }

char read()
{
    while (!pending()) {
    }
    return static_cast<char>(uart_dr.read());
}

}
