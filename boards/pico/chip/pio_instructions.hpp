#pragma once

#include <cstdint>

/// Instructions of the PIO's state machines, as their bits, named as its assembler has them. Each machine has
/// one side-set pin: that leaves four bits for a delay.
namespace kfast::pico::pio {

inline constexpr std::uint32_t side_0 = 0 << 12;
inline constexpr std::uint32_t side_1 = 1 << 12;

/// The instruction takes that many cycles, 1 … 16.
constexpr std::uint32_t lasting(std::uint32_t cycles) { return (cycles - 1) << 8; }

constexpr std::uint32_t jmp(std::uint32_t to) { return 0x0000 | to; }
constexpr std::uint32_t jmp_x_dec(std::uint32_t to) { return 0x0040 | to; }
constexpr std::uint32_t jmp_not_y(std::uint32_t to) { return 0x0060 | to; }

inline constexpr std::uint32_t wait_irq_0 = 0x20C0; // and clear it
inline constexpr std::uint32_t irq_set_0 = 0xC000;

inline constexpr std::uint32_t pull = 0x80A0;         // waits for a word
inline constexpr std::uint32_t pull_noblock = 0x8080; // what x holds if nothing has come

inline constexpr std::uint32_t out_pins_1 = 0x6001;
inline constexpr std::uint32_t out_pins_8 = 0x6008;
inline constexpr std::uint32_t out_pindirs_8 = 0x6088;
inline constexpr std::uint32_t out_y_8 = 0x6048;

inline constexpr std::uint32_t mov_pins_pins = 0xA000;
inline constexpr std::uint32_t mov_pins_null = 0xA003;
inline constexpr std::uint32_t mov_pins_not_null = 0xA00B;
inline constexpr std::uint32_t mov_x_y = 0xA022;
inline constexpr std::uint32_t mov_x_isr = 0xA026;
inline constexpr std::uint32_t nop = 0xA042; // mov y, y
inline constexpr std::uint32_t mov_y_osr = 0xA047;
inline constexpr std::uint32_t mov_isr_osr = 0xA0C7;
inline constexpr std::uint32_t mov_osr_not_null = 0xA0EB;

constexpr std::uint32_t set_pins(std::uint32_t value) { return 0xE000 | value; }
constexpr std::uint32_t set_x(std::uint32_t value) { return 0xE020 | value; }
inline constexpr std::uint32_t set_pindirs_1 = 0xE081;

}
