#pragma once

#include "firmware/board_settings.hpp"

#include <optional>
#include <string>
#include <vector>

namespace kfast::config {

/// A wire between a part and the edge of a Pico.
struct Connection {
    std::string part; ///< "display", "button 1"
    std::string end;  ///< of the part, as it is printed there: "SCL, SCK or CLK"
    int pin = 0;      ///< of the edge (pico_edge.hpp)
    std::optional<Pin> gpio = std::nullopt;
    std::string purpose; ///< "SPI0 SCK", "plays blink"; may be empty
};

/// All wires that settings for a Pico ask for, part by part; they keep its rules (firmware/board_rules.hpp).
std::vector<Connection> wiring(const BoardSettings& settings);

}
