#pragma once

#include "firmware/settings/board_settings.hpp"

#include <optional>
#include <string_view>

namespace kfast::config {

/// What a pin is for beside which sellers of displays print this, in small letters: "rst" is reset. The names
/// of roles themselves are not among them.
std::optional<PinRole> role_printed_as(std::string_view name);

}
