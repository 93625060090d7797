#pragma once

#include "boards/pico/chip/register.hpp"

#include <cstdint>

namespace kfast::pico::dma {

/// What requests the next piece: the numbers of the chip's table of DREQs. `permanent`: nothing, at once.
enum class Dreq : std::uint32_t { pio0_tx0 = 0, spi0_tx = 16, spi1_tx = 18, permanent = 0x3F };

/// What is written at once: 1, 2 or 4 bytes.
enum class DataSize : std::uint32_t { byte, halfword, word };

/// The registers of a channel, some of them in its aliases AL1 and AL3.
struct Channel {
    std::uint32_t number;

    constexpr Register read_addr() const { return at(0x00); }
    constexpr Register write_addr() const { return at(0x04); }
    constexpr Register trans_count() const { return at(0x08); }
    constexpr Register ctrl_trig() const { return at(0x0C); }
    constexpr Register al1_ctrl() const { return at(0x10); }
    // The two are adjacent, 8 bytes aligned to 8.
    constexpr Register al3_trans_count() const { return at(0x38); }
    constexpr Register al3_read_addr_trig() const { return at(0x3C); }

private:
    constexpr Register at(std::uint32_t offset) const
    {
        return Register{0x5000'0000 + 0x40 * number + offset};
    }
};

// Fields of a channel's CTRL.
inline constexpr std::uint32_t ctrl_en = 1 << 0;
inline constexpr std::uint32_t ctrl_high_priority = 1 << 1;
inline constexpr std::uint32_t ctrl_incr_read = 1 << 4;
inline constexpr std::uint32_t ctrl_incr_write = 1 << 5;
inline constexpr std::uint32_t ctrl_irq_quiet = 1 << 21; // no interrupt
inline constexpr std::uint32_t ctrl_busy = 1 << 24;

constexpr std::uint32_t ctrl_data_size(DataSize piece) { return static_cast<std::uint32_t>(piece) << 2; }
/// What is written goes round in 2 to the power of `bits` bytes.
constexpr std::uint32_t ctrl_ring_write(std::uint32_t bits) { return 1 << 10 | bits << 6; }
/// Which channel begins when this one has finished: itself for none.
constexpr std::uint32_t ctrl_chain_to(Channel channel) { return channel.number << 11; }
constexpr std::uint32_t ctrl_treq_sel(Dreq request) { return static_cast<std::uint32_t>(request) << 15; }

}
