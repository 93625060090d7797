#pragma once

#include "firmware/settings/board_settings.hpp"

#include <optional>
#include <string_view>

namespace kfast::config {

/// What is printed beside the pin of a display: "SCL, SCK or CLK", the most likely first. Empty where such
/// displays have no such pin. Of a parallel bus, data is "D" without its number.
std::string_view panel_label(PinRole role, const BoardSettings& settings);

/// Where to wire a pin that the display may have and no GPIO drives.
enum class IdleLevel : std::uint8_t { none, low, high };

/// The level that keeps a display ready that has a pin for the role if the settings have none.
IdleLevel idle_level(PinRole role, const BoardSettings& settings);

/// The role of a pin that sellers of displays label with this, in small letters: "rst" is reset. The names of
/// roles themselves are not among them.
std::optional<PinRole> role_printed_as(std::string_view name);

}
