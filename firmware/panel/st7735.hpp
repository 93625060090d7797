#pragma once

#include "firmware/panel/dcs_panel.hpp"

#include <array>

namespace kfast {

/// Register values as found in drivers of modules with the ST7735R.
inline constexpr auto st7735_start_up = std::to_array<StartUpStep>({
    {.command = 0x01, .wait = {120'000}},            // SWRESET
    {.command = 0x11, .wait = {120'000}},            // SLPOUT
    {0xB1, 3, {0x01, 0x2C, 0x2D}},                   // FRMCTR1: normal
    {0xB2, 3, {0x01, 0x2C, 0x2D}},                   // FRMCTR2: idle
    {0xB3, 6, {0x01, 0x2C, 0x2D, 0x01, 0x2C, 0x2D}}, // FRMCTR3: partial
    {0xB4, 1, {0x07}},                               // INVCTR: by lines
    {0xC0, 3, {0xA2, 0x02, 0x84}},                   // PWCTR1
    {0xC1, 1, {0xC5}},                               // PWCTR2
    {0xC2, 2, {0x0A, 0x00}},                         // PWCTR3
    {0xC3, 2, {0x8A, 0x2A}},                         // PWCTR4
    {0xC4, 2, {0x8A, 0xEE}},                         // PWCTR5
    {0xC5, 1, {0x0E}},                               // VMCTR1
    {0x3A, 1, {0x05}},                               // COLMOD: 16 bits
    // GMCTRP1
    {0xE0,
     16,
     {0x02, 0x1C, 0x07, 0x12, 0x37, 0x32, 0x29, 0x2D, 0x29, 0x25, 0x2B, 0x39, 0x00, 0x01, 0x03, 0x10}},
    // GMCTRN1
    {0xE1,
     16,
     {0x03, 0x1D, 0x07, 0x06, 0x2E, 0x2C, 0x29, 0x2D, 0x2E, 0x2E, 0x37, 0x3F, 0x00, 0x00, 0x02, 0x10}},
    {0x13}, // NORON
});

/// Sitronix ST7735: LCD of up to 132 x 162 pixels. It does not control its backlight.
inline constexpr DcsController st7735{
    .memory = facts_of(Controller::st7735).memory, .start_up = st7735_start_up, .dims = false};

template <>
struct PanelDriver<Controller::st7735> : DcsDriver<st7735> {
};

}
