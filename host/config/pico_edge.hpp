#pragma once

#include "firmware/settings/board_settings.hpp"

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

}
