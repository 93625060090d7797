#pragma once

#include "firmware/settings/board_rules.hpp"
#include "firmware/settings/board_settings.hpp"

#include <optional>
#include <string>
#include <string_view>

/// The forty pins along the edge of a Pico, counted from 1: down the left side and up the right one, the USB
/// socket on top.
namespace kfast::config {

inline constexpr int edge_pins = 40;
inline constexpr int pins_of_side = edge_pins / 2;

/// As printed on the board: "GP18", "GND", "3V3".
std::string edge_name(int pin);

/// Of a GPIO that is on the edge.
int edge_pin(Pin gpio);

/// "left" or "right".
std::string_view edge_side(int pin);

/// On the same side.
int nearest_ground(int pin);

/// The pins of a Pico in words.

/// The last one that has seven more behind it on the edge.
inline constexpr int last_pin_of_eight = 15;

/// "GP18"; also of a pin that there is not.
std::string pin_name(int pin);

/// "GP0 to GP22, GP26 to GP28"
std::string pins_on_edge();

/// Those of the edge that nobody uses.
std::string free_pins(const BoardSettings& settings);

/// Those of the edge that can carry clock, data or the log; only of the unit whose name is given: "SPI0".
std::string pins_that_carry(PinRole role, BusKind bus, std::optional<std::string_view> unit);

}
