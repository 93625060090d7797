#pragma once

#include <concepts>
#include <cstdint>
#include <string_view>

namespace kfast {

// Compound requirements would be torn apart.
// clang-format off

/// A line to somebody who reads what a board tells, and answers.
template <class C>
concept Console = requires(C& console, char letter) {
    /// Waits for room.
    { console.write(letter) } -> std::same_as<void>;
    /// Whether read() has a byte to give.
    { console.pending() } -> std::same_as<bool>;
    /// Waits for a byte.
    { console.read() } -> std::same_as<char>;
};

// clang-format on

template <Console C>
void write_text(C& console, std::string_view text)
{
    for (const char letter : text)
        console.write(letter);
}

template <Console C>
void write_decimal(C& console, std::uint32_t number)
{
    if (number >= 10)
        write_decimal(console, number / 10);
    console.write(static_cast<char>('0' + number % 10));
}

/// Eight digits.
template <Console C>
void write_hex(C& console, std::uint32_t number)
{
    for (int shift = 28; shift >= 0; shift -= 4)
        console.write("0123456789abcdef"[number >> shift & 15]);
}

}
