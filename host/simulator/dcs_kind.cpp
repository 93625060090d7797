#include "host/simulator/dcs_kind.hpp"

#include <array>

namespace kfast {
namespace {

using Forms = std::vector<CommandForm>;
using std::chrono::milliseconds;

constexpr int not_modelled = CommandForm::not_modelled;

const Forms every_kind{
    {0x00, 0},            // nothing
    {0x01, 0},            // software reset
    {0x04, not_modelled}, // reading, up to 0x0F
    {0x09, not_modelled}, //
    {0x0A, not_modelled}, //
    {0x0B, not_modelled}, //
    {0x0C, not_modelled}, //
    {0x0D, not_modelled}, //
    {0x0E, not_modelled}, //
    {0x0F, not_modelled}, //
    {0x10, 0},            // sleep in
    {0x11, 0},            // sleep out
    {0x12, not_modelled}, // partial mode
    {0x13, 0},            // normal mode
    {0x20, 0},            // inversion off
    {0x21, 0},            // inversion on
    {0x28, 0},            // display off
    {0x29, 0},            // display on
    {0x2A, 4},            // columns
    {0x2B, 4},            // rows
    {0x2C, 0},            // write
    {0x2E, not_modelled}, // read
    {0x30, 4},            // area of the partial mode
    {0x33, 6},            // area that scrolls
    {0x34, 0},            // tearing effect off
    {0x35, 1},            // tearing effect on
    {0x36, 1},            // memory access
    {0x37, 2},            // scroll
    {0x38, 0},            // idle mode off
    {0x39, not_modelled}, // idle mode, with eight colours
    {0x3A, 1},            // pixel format
    {0xDA, not_modelled}, // reading, up to 0xDC
    {0xDB, not_modelled}, //
    {0xDC, not_modelled}, //
};

Forms with(Forms forms, const Forms& more)
{
    forms.insert(forms.end(), more.begin(), more.end());
    return forms;
}

/// What came with the later versions of the standard.
const Forms later_commands{
    {0x3C, 0},            // go on writing
    {0x3E, not_modelled}, // go on reading
    {0x44, 2},            // scan line of the tearing effect
    {0x45, not_modelled}, // reading of the scan line
    {0x51, 1},            // brightness
    {0x52, not_modelled}, // reading of it
    {0x53, 1},            // what brightness governs
};

constexpr FixedBits memory_access{0x36, 0, 0x03, 0x00}; // reserved
constexpr FixedBits scroll_high{0x37, 0, 0xFF, 0x00};   // nothing is scrolled
constexpr FixedBits scroll_low{0x37, 1, 0xFF, 0x00};    //

constexpr std::array common_fixed_bits{memory_access, scroll_high, scroll_low};

constexpr std::array st7789_bits{
    memory_access,
    scroll_high,
    scroll_low,
    FixedBits{0xB0, 0, 0x13, 0x00}, // pictures come from the memory, and into it from this bus
    FixedBits{0xB0, 1, 0x08, 0x00}, // high byte first
};

constexpr std::array ili9341_bits{
    memory_access,
    scroll_high,
    scroll_low,
    FixedBits{0xB6, 1, 0xC0, 0x80}, // normally white, scanned from the first line on
    FixedBits{0xB6, 2, 0x3F, 0x27}, // 320 lines
    FixedBits{0xF6, 0, 0xE8, 0x00}, // memory access means what it says
    FixedBits{0xF6, 2, 0x2E, 0x00}, // high byte first, pictures come from the memory
};

const Forms st7789_commands{
    {0x26, 1},                                      // gamma curve
    {0x55, 1},                                      // brightness by content
    {0x5E, 1},                                      // least brightness
    {0xB0, 2},                                      // memory
    {0xB1, 3},                                      // RGB interface
    {0xB2, 5},                                      // porches
    {0xB3, 3},                                      // frame rate in idle mode
    {0xB5, 1},                                      // partial mode
    {0xB7, 1},                                      // gate voltages
    {0xB8, 4},                                      // gate timing
    {0xBA, 1},                                      // digital gamma
    {0xBB, 1},                                      // VCOM
    {0xBC, 1},    {0xBD, 1},                        // power saving
    {0xC0, 1},                                      // LCM
    {0xC1, 3},                                      // identity
    {0xC2, 1, 2},                                   // VDV and VRH; drivers leave out the second
    {0xC3, 1},    {0xC4, 1},                        // VRH, VDV
    {0xC5, 1},                                      // VCOM offset
    {0xC6, 1},                                      // frame rate
    {0xC7, 1},                                      // brightness by content
    {0xC8, 1},    {0xCA, 1},                        // registers
    {0xCC, 1},                                      // PWM
    {0xD0, 2},                                      // power
    {0xD2, 1},                                      // VAP and VAN
    {0xD6, 1},                                      // in many start-up tables, unpublished
    {0xDF, 4},                                      // second command table
    {0xE0, 14},   {0xE1, 14},                       // gamma
    {0xE2, 64},   {0xE3, 64},                       // digital gamma
    {0xE4, 3},                                      // gates
    {0xE8, 1},                                      // power
    {0xE9, 3},                                      // equalizing
    {0xEC, 1},    {0xFA, 4},  {0xFC, 2}, {0xFE, 2}, // non-volatile memory
};

const Forms ili9341_commands{
    {0x26, 1},                                      // gamma curve
    {0x2D, 128},                                    // colour table
    {0x55, 1},                                      // brightness by content
    {0x5E, 1},                                      // least brightness
    {0xB0, 1},                                      // RGB interface
    {0xB1, 2},    {0xB2, 2},  {0xB3, 2},            // frame rates
    {0xB4, 1},                                      // inversion of the drive
    {0xB5, 4},                                      // porches
    {0xB6, 3, 4},                                   // scanning; drivers leave out the last
    {0xB7, 1},                                      // entry mode
    {0xB8, 1},    {0xB9, 1},  {0xBA, 1}, {0xBB, 1}, // backlight
    {0xBC, 1},    {0xBE, 1},  {0xBF, 1},            //
    {0xC0, 1},    {0xC1, 1},                        // power
    {0xC5, 2},    {0xC7, 1},                        // VCOM
    {0xCB, 5},    {0xCF, 3},                        // power A, B
    {0xD0, 3},    {0xD1, 3},                        // non-volatile memory
    {0xE0, 15},   {0xE1, 15},                       // gamma
    {0xE2, 16},   {0xE3, 64},                       // digital gamma
    {0xE8, 3},    {0xE9, 3},  {0xEA, 2},            // timing
    {0xED, 4},                                      // power on sequence
    {0xEF, 3},                                      // in many start-up tables, unpublished
    {0xF2, 1},                                      // gamma of three
    {0xF6, 3},                                      // interface
    {0xF7, 1},                                      // pump ratio
};

const Forms st7735_commands{
    {0x26, 1},                                                // gamma curve
    {0x2D, 128},                                              // colour table
    {0xB1, 3},   {0xB2, 3},  {0xB3, 6},                       // frame rates
    {0xB4, 1},                                                // inversion of the drive
    {0xB6, 2},                                                // display function
    {0xC0, 3},   {0xC1, 1},  {0xC2, 2}, {0xC3, 2}, {0xC4, 2}, // power
    {0xC5, 1},   {0xC7, 1},                                   // VCOM
    {0xD1, 1},   {0xD2, 1},                                   // identity
    {0xD9, 1},   {0xDE, 2},  {0xDF, 2},                       // non-volatile memory
    {0xE0, 16},  {0xE1, 16},                                  // gamma
    {0xFC, 1},                                                // pump clock
};

/// The meanings of most are unpublished.
const Forms gc9a01_commands{
    {0xFE, 0},  {0xEF, 0}, // open the inner registers
    {0x62, 12}, {0x63, 12}, {0x64, 7}, {0x66, 10}, {0x67, 10}, {0x70, 9}, {0x74, 7}, {0x84, 1}, {0x85, 1},
    {0x86, 1},  {0x87, 1},  {0x88, 1}, {0x89, 1},  {0x8A, 1},  {0x8B, 1}, {0x8C, 1}, {0x8D, 1}, {0x8E, 1},
    {0x8F, 1},  {0x90, 4},  {0x98, 2}, {0x99, 2},  {0xAE, 1},  {0xB6, 2}, {0xBC, 1}, {0xBD, 1}, {0xBE, 1},
    {0xC3, 1},  {0xC4, 1},  {0xC9, 1}, {0xCD, 1},  {0xDF, 3},  {0xE1, 2}, {0xE8, 1}, {0xEB, 1}, {0xED, 2},
    {0xF0, 6},  {0xF1, 6},  {0xF2, 6}, {0xF3, 6},  {0xFF, 3},
};

}

const DcsKind st7789_kind{.commands = with(with(every_kind, later_commands), st7789_commands),
                          .fixed_bits = st7789_bits,
                          .takes_12_bits = true,
                          .has_rgb_interface = true,
                          .is_wired_backwards = false,
                          .reset_time = milliseconds{5},
                          .wake_time = milliseconds{5}};
const DcsKind ili9341_kind{.commands = with(with(every_kind, later_commands), ili9341_commands),
                           .fixed_bits = ili9341_bits,
                           .takes_12_bits = false,
                           .has_rgb_interface = true,
                           .is_wired_backwards = true,
                           .reset_time = milliseconds{5},
                           .wake_time = milliseconds{5}};
const DcsKind st7735_kind{.commands = with(every_kind, st7735_commands),
                          .fixed_bits = common_fixed_bits,
                          .takes_12_bits = true,
                          .has_rgb_interface = false,
                          .is_wired_backwards = false,
                          .reset_time = milliseconds{120},
                          .wake_time = milliseconds{120}};
const DcsKind gc9a01_kind{.commands = with(with(every_kind, later_commands), gc9a01_commands),
                          .fixed_bits = common_fixed_bits,
                          .takes_12_bits = false,
                          .has_rgb_interface = true,
                          .is_wired_backwards = false,
                          .reset_time = milliseconds{5},
                          .wake_time = milliseconds{5}};

}
