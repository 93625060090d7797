#pragma once

#include "firmware/panel/dcs_panel.hpp"

#include <array>

namespace kfast {

/// Register values as found in drivers of 240x240 and 240x320 IPS modules.
inline constexpr auto st7789_start_up = std::to_array<StartUpStep>({
    {.command = 0x01, .wait = {120'000}},      // SWRESET
    {.command = 0x11, .wait = {120'000}},      // SLPOUT
    {0x3A, 1, {0x55}},                         // COLMOD: 16 bits
    {0xB0, 2, {0x00, 0xC0}},                   // RAMCTRL: high byte first, the top bit fills the sixth
    {0xB2, 5, {0x0C, 0x0C, 0x00, 0x33, 0x33}}, // PORCTRL
    {0xB7, 1, {0x35}},                         // GCTRL
    {0xBB, 1, {0x19}},                         // VCOMS
    {0xC0, 1, {0x2C}},                         // LCMCTRL
    {0xC2, 1, {0x01}},                         // VDVVRHEN
    {0xC3, 1, {0x12}},                         // VRHS
    {0xC4, 1, {0x20}},                         // VDVS
    {0xC6, 1, {0x0F}},                         // FRCTRL2: 60 Hz
    {0xD0, 2, {0xA4, 0xA1}},                   // PWCTRL1
    // PVGAMCTRL
    {0xE0, 14, {0xD0, 0x04, 0x0D, 0x11, 0x13, 0x2B, 0x3F, 0x54, 0x4C, 0x18, 0x0D, 0x0B, 0x1F, 0x23}},
    // NVGAMCTRL
    {0xE1, 14, {0xD0, 0x04, 0x0C, 0x11, 0x13, 0x2C, 0x3F, 0x44, 0x51, 0x2F, 0x1F, 0x1F, 0x20, 0x23}},
    {0x13}, // NORON
});

/// Sitronix ST7789: LCD of up to 240 x 320 pixels.
inline constexpr DcsController st7789{
    .memory = facts_of(Controller::st7789).memory, .start_up = st7789_start_up, .dims = true};

template <>
struct PanelDriver<Controller::st7789> : DcsDriver<st7789> {
};

}
