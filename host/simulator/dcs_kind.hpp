#pragma once

#include "host/simulator/controller_model.hpp"

#include <chrono>
#include <cstdint>
#include <span>
#include <vector>

namespace kfast {

/// Bits of a parameter that must have this value because the model, or the maker, has no other.
struct FixedBits {
    std::uint8_t code;
    std::size_t parameter; ///< counted from 0
    std::uint8_t mask;
    std::uint8_t value;
};

/// How the controllers of the MIPI DCS family differ.
struct DcsKind {
    std::vector<CommandForm> commands;
    std::span<const FixedBits> fixed_bits;
    bool takes_12_bits;
    /// Its pixel format is in the upper half of 3Ah's parameter; without one the upper bits are not read.
    bool has_rgb_interface;
    /// Whether glasses are wired from its last column to its first: bit 5 of B6h's second parameter corrects
    /// that.
    bool is_wired_backwards;
    /// From a reset to the first command that is accepted.
    std::chrono::milliseconds reset_time;
    /// From sleep out to the next command.
    std::chrono::milliseconds wake_time;
};

extern const DcsKind st7789_kind;
extern const DcsKind ili9341_kind;
extern const DcsKind st7735_kind;
extern const DcsKind gc9a01_kind;

}
