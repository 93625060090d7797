#pragma once

#include "firmware/settings/board_settings.hpp"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace kfast::config {

/// The converters that move a beam, in a case with 14 pins.
inline constexpr const char* converter_part = "MCP4922";

/// Where their voltages come out, and what they drive.
struct ConverterOutput {
    std::string_view end;
    std::string_view axis;
};
inline constexpr std::array<ConverterOutput, 2> converter_outputs{{{"VOUTA (14)", "x"}, {"VOUTB (10)", "y"}}};

/// A wire between a part and the edge of a Pico.
struct Connection {
    std::string part; ///< "display", "button 1"
    std::string end;  ///< of the part, as it is printed there: "SCL, SCK or CLK"
    int pin = 0;      ///< of the edge (pico_pins.hpp)
    std::optional<Pin> gpio = std::nullopt;
    std::string purpose = {}; ///< "SPI0 SCK", "plays blink"; may be empty
    bool is_optional = false; ///< only where the part has such an end; no drawing shows it
};

/// All wires that settings for a Pico require, part by part; they keep its rules
/// (firmware/settings/board_rules.hpp).
std::vector<Connection> wiring(const BoardSettings& settings);

/// A Pico from above in letters, its USB socket on top, with what goes to each pin beside it.
std::string pico_drawing(std::span<const Connection> wires);

}
