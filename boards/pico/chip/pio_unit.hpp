#pragma once

#include "boards/pico/chip/register.hpp"

#include <cstdint>

/// PIO0 and its state machines.
namespace kfast::pico::pio {

inline constexpr Register control{0x5020'0000};
inline constexpr Register fifo_status{0x5020'0004};
inline constexpr Register events{0x5020'0008};
constexpr Register program_memory(std::uint32_t at) { return Register{0x5020'0048 + 4 * at}; }

// In `control`, of machine 0; those of the others follow.
inline constexpr std::uint32_t machine_enable = 1 << 0;
inline constexpr std::uint32_t machine_restart = 1 << 4;
inline constexpr std::uint32_t divisor_restart = 1 << 8;
// In `fifo_status`, likewise.
inline constexpr std::uint32_t transmit_full = 1 << 16;
inline constexpr std::uint32_t transmit_empty = 1 << 24;
// In `events`, likewise; kept until a 1 is written.
inline constexpr std::uint32_t stalled = 1 << 24;

struct Machine {
    std::uint32_t number;

    constexpr Register transmit() const { return Register{0x5020'0010 + 4 * number}; }
    constexpr Register clock_divisor() const { return own(0xC8); }
    constexpr Register execution() const { return own(0xCC); }
    constexpr Register shifting() const { return own(0xD0); }
    constexpr Register execute_now() const { return own(0xD8); }
    constexpr Register pin_ranges() const { return own(0xDC); }

private:
    constexpr Register own(std::uint32_t of_first) const
    {
        return Register{0x5020'0000 + of_first + 0x18 * number};
    }
};

// Where fields begin: of clock_divisor,
inline constexpr int divisor_at = 16;
// of execution,
inline constexpr int wrap_to_at = 7;
inline constexpr int wrap_from_at = 12;
// of shifting, where 0 is to the left, the highest bits first,
inline constexpr std::uint32_t refill_by_itself = 1 << 17;
inline constexpr int refill_after_at = 25;
// and of pin_ranges.
inline constexpr int out_base_at = 0;
inline constexpr int set_base_at = 5;
inline constexpr int side_set_base_at = 10;
inline constexpr int in_base_at = 15;
inline constexpr int out_pins_at = 20;
inline constexpr std::uint32_t one_set_pin = 1u << 26;
inline constexpr std::uint32_t one_side_set_pin = 1u << 29;

}
