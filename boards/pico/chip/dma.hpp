#pragma once

#include "boards/pico/chip/dma_channel.hpp"
#include "boards/pico/chip/register.hpp"

#include <cstddef>
#include <span>

/// Memory to a register, at the pace of the register's unit: one channel, for the display's bus.
namespace kfast::pico::dma {

/// Needs start_clocks().
void begin();
/// `bytes` is whole pieces, aligned to them, and stays as it is until busy() is false. Not while busy().
void start(std::span<const std::byte> bytes, DataSize piece, Register target, Dreq request);
/// Whether pieces are left that the unit has not taken. It may still be sending when none is.
bool busy();

}
