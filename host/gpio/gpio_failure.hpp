#pragma once

#include "host/gpio/gpio_lookup.hpp"
#include "host/program/failure.hpp"

#include <string>

namespace kfast {

/// Why a chip cannot be opened: `error` is what errno says.
Failure cannot_open_chip(const std::string& path, int error);

/// Why its lines are not given.
Failure cannot_have_lines(const FoundLines& found, int error, GpioDrive drive);

/// Why lines that this program has cannot be set.
Failure cannot_set_lines(const std::string& chip, int error);

/// "gpiochip0 (pinctrl-bcm2711)"
std::string text_of(const GpioChip& chip);

}
