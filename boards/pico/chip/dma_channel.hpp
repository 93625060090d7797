#pragma once

#include "boards/pico/chip/register.hpp"

#include <cstdint>

namespace kfast::pico::dma {

/// Who asks for the next piece: the numbers of the chip's table.
enum class Request : std::uint32_t { pio0_tx0 = 0, spi0_tx = 16, spi1_tx = 18, nobody = 0x3F };

/// What is written at once.
enum class Piece : std::uint32_t { byte, word_16, word_32 };

/// The registers of a channel.
struct Channel {
    std::uint32_t number;

    constexpr Register read_address() const { return at(0x00); }
    constexpr Register write_address() const { return at(0x04); }
    constexpr Register transfer_count() const { return at(0x08); }
    constexpr Register control_and_start() const { return at(0x0C); }
    constexpr Register control() const { return at(0x10); }
    // The two lie side by side, 8 bytes aligned to 8.
    constexpr Register transfer_count_before_start() const { return at(0x38); }
    constexpr Register read_address_and_start() const { return at(0x3C); }

private:
    constexpr Register at(std::uint32_t offset) const
    {
        return Register{0x5000'0000 + 0x40 * number + offset};
    }
};

// Bits of a channel's control.
inline constexpr std::uint32_t enabled = 1 << 0;
inline constexpr std::uint32_t high_priority = 1 << 1;
inline constexpr std::uint32_t read_next = 1 << 4;
inline constexpr std::uint32_t write_next = 1 << 5;
inline constexpr std::uint32_t quiet = 1 << 21; // no interrupt
inline constexpr std::uint32_t is_busy = 1 << 24;

constexpr std::uint32_t piece_of(Piece piece) { return static_cast<std::uint32_t>(piece) << 2; }
/// What is written goes round in 2 to the power of `bits` bytes.
constexpr std::uint32_t write_round(std::uint32_t bits) { return 1 << 10 | bits << 6; }
/// Which channel begins when this one has finished: itself for none.
constexpr std::uint32_t chain_to(Channel channel) { return channel.number << 11; }
constexpr std::uint32_t paced_by(Request request) { return static_cast<std::uint32_t>(request) << 15; }

}
