#pragma once

#include "firmware/settings/board_rules.hpp"

#include <optional>
#include <string>
#include <string_view>

/// The pins of a Pico in words.
namespace kfast::config {

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
