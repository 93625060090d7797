#pragma once

#include "firmware/panel/dcs_panel.hpp"

#include <array>

namespace kfast {

/// Register values as found in drivers of 240x320 modules.
inline constexpr auto ili9341_start_up = std::to_array<StartUpStep>({
    {.command = 0x01, .wait = {120'000}},      // SWRESET
    {0xEF, 3, {0x03, 0x80, 0x02}},             // not documented
    {0xCF, 3, {0x00, 0xC1, 0x30}},             // power control B
    {0xED, 4, {0x64, 0x03, 0x12, 0x81}},       // power-on sequence
    {0xE8, 3, {0x85, 0x00, 0x78}},             // driver timing A
    {0xCB, 5, {0x39, 0x2C, 0x00, 0x34, 0x02}}, // power control A
    {0xF7, 1, {0x20}},                         // pump ratio
    {0xEA, 2, {0x00, 0x00}},                   // driver timing B
    {0xC0, 1, {0x23}},                         // power control 1: GVDD 4.60 V
    {0xC1, 1, {0x10}},                         // power control 2
    {0xC5, 2, {0x3E, 0x28}},                   // VCOM control 1
    {0xC7, 1, {0x86}},                         // VCOM control 2
    {0x3A, 1, {0x55}},                         // COLMOD: 16 bits
    {0xB1, 2, {0x00, 0x1B}},                   // frame rate: 70 Hz
    {0xB6, 3, {0x08, 0xA2, 0x27}},             // display function: glasses are wired from S720 to S1
    {0xF2, 1, {0x00}},                         // 3-gamma off
    {0x26, 1, {0x01}},                         // gamma curve
    // positive gamma
    {0xE0, 15, {0x0F, 0x31, 0x2B, 0x0C, 0x0E, 0x08, 0x4E, 0xF1, 0x37, 0x07, 0x10, 0x03, 0x0E, 0x09, 0x00}},
    // negative gamma
    {0xE1, 15, {0x00, 0x0E, 0x14, 0x03, 0x11, 0x07, 0x31, 0xC1, 0x48, 0x08, 0x0F, 0x0C, 0x31, 0x36, 0x0F}},
    {.command = 0x11, .wait = {120'000}}, // SLPOUT
});

/// Ilitek ILI9341: LCD of 240 x 320 pixels.
inline constexpr DcsController ili9341{
    .memory = facts_of(Controller::ili9341).memory, .start_up = ili9341_start_up, .dims = true};

template <>
struct PanelDriver<Controller::ili9341> : DcsDriver<ili9341> {
};

}
