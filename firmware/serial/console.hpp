#pragma once

#include "core/bytes/crc32.hpp"

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace kfast {

// Compound requirements would be torn apart.
// clang-format off

/// An output for letters.
template <class O>
concept LetterOutput = requires(O& output, char letter) {
    { output.write(letter) } -> std::same_as<void>;
};

/// A line to somebody who reads what a board prints, and answers. Its write() waits for room.
template <class C>
concept Console = LetterOutput<C> && requires(C& console) {
    /// Whether read() has a byte to give.
    { console.pending() } -> std::same_as<bool>;
    /// Waits for a byte.
    { console.read() } -> std::same_as<char>;
};

// clang-format on

template <LetterOutput O>
void write_text(O& output, std::string_view text)
{
    for (const char letter : text)
        output.write(letter);
}

template <LetterOutput O>
void write_decimal(O& output, std::uint32_t number)
{
    if (number >= 10)
        write_decimal(output, number / 10);
    output.write(static_cast<char>('0' + number % 10));
}

/// Writes eight digits.
template <LetterOutput O>
void write_hex(O& output, std::uint32_t number)
{
    for (int shift = 28; shift >= 0; shift -= 4)
        output.write("0123456789abcdef"[number >> shift & 15]);
}

/// "SCENE <bytes> <CRC-32>". `scene` holds the bytes of the scene and no others.
template <LetterOutput O>
void write_scene_line(O& output, std::span<const std::byte> scene)
{
    Crc32 checksum;
    checksum.add(scene);
    write_text(output, "SCENE ");
    write_decimal(output, static_cast<std::uint32_t>(scene.size()));
    output.write(' ');
    write_hex(output, checksum.value());
    output.write('\n');
}

}
