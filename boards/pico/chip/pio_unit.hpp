#pragma once

#include "boards/pico/chip/register.hpp"

#include <cstdint>

/// PIO0 and its state machines.
namespace kfast::pico::pio {

inline constexpr Register ctrl{0x5020'0000};
inline constexpr Register fstat{0x5020'0004};
inline constexpr Register fdebug{0x5020'0008};
constexpr Register instr_mem(std::uint32_t at) { return Register{0x5020'0048 + 4 * at}; }

// In `ctrl`, of machine 0; those of the others follow.
inline constexpr std::uint32_t ctrl_sm_enable = 1 << 0;
inline constexpr std::uint32_t ctrl_sm_restart = 1 << 4;
inline constexpr std::uint32_t ctrl_clkdiv_restart = 1 << 8;
// In `fstat`, of machine 0, too.
inline constexpr std::uint32_t fstat_txfull = 1 << 16;
inline constexpr std::uint32_t fstat_txempty = 1 << 24;
// In `fdebug`, of machine 0, too; kept until a 1 is written.
inline constexpr std::uint32_t fdebug_txstall = 1 << 24;

struct Machine {
    std::uint32_t number;

    constexpr Register txf() const { return Register{0x5020'0010 + 4 * number}; }
    constexpr Register clkdiv() const { return own(0xC8); }
    constexpr Register execctrl() const { return own(0xCC); }
    constexpr Register shiftctrl() const { return own(0xD0); }
    constexpr Register instr() const { return own(0xD8); }
    constexpr Register pinctrl() const { return own(0xDC); }

private:
    constexpr Register own(std::uint32_t of_first) const
    {
        return Register{0x5020'0000 + of_first + 0x18 * number};
    }
};

// Where fields begin: of clkdiv,
inline constexpr int clkdiv_int_lsb = 16;
// of execctrl,
inline constexpr int execctrl_wrap_bottom_lsb = 7;
inline constexpr int execctrl_wrap_top_lsb = 12;
// of shiftctrl, where 0 is to the left, the highest bits first,
inline constexpr std::uint32_t shiftctrl_autopull = 1 << 17;
inline constexpr int shiftctrl_pull_thresh_lsb = 25;
// and of pinctrl.
inline constexpr int pinctrl_out_base_lsb = 0;
inline constexpr int pinctrl_set_base_lsb = 5;
inline constexpr int pinctrl_sideset_base_lsb = 10;
inline constexpr int pinctrl_in_base_lsb = 15;
inline constexpr int pinctrl_out_count_lsb = 20;
inline constexpr std::uint32_t pinctrl_set_count_1 = 1u << 26;
inline constexpr std::uint32_t pinctrl_sideset_count_1 = 1u << 29;

}
