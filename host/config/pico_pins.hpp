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

/// The name printed on the board: "GP18", "GND", "3V3".
std::string edge_name(int pin);

/// The pin of a GPIO that is on the edge.
int edge_pin(Pin gpio);

/// "left" or "right".
std::string_view edge_side(int pin);

/// The nearest ground pin on the same side.
int nearest_ground(int pin);

/// The last one that has seven more after it on the edge.
inline constexpr int last_pin_of_eight = 15;

/// "GP18"; also for a pin that does not exist.
std::string pin_name(int pin);

/// "GP0 to GP22, GP26 to GP28"
std::string pins_on_edge();

/// The pins of the edge that are not used.
std::string free_pins(const BoardSettings& settings);

/// The pins of the edge that can carry clock, data or the log; only of the unit that is named: "SPI0".
std::string pins_that_carry(PinRole role, BusKind bus, std::optional<std::string_view> unit);

}
