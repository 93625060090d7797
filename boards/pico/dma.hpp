#pragma once

#include "boards/pico/register.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

/// Memory to a register, at the pace of the register's unit: one channel, for the display's bus.
namespace kfast::pico::dma {

/// Who asks for the next piece: the numbers of the chip's table.
enum class Request : std::uint32_t { pio0_tx0 = 0, spi0_tx = 16, spi1_tx = 18 };

/// What is written at once.
enum class Piece : std::uint32_t { byte, word_16 };

/// Needs start_clocks().
void begin();
/// `bytes` is whole pieces, aligned to them, and stays as it is until busy() is false. Not while busy().
void start(std::span<const std::byte> bytes, Piece piece, Register target, Request request);
/// Whether pieces are left that the unit has not taken. It may still be sending when none is.
bool busy();

}
