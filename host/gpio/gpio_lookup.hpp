#pragma once

#include "host/gpio/gpio_chip.hpp"
#include "host/gpio/gpio_outputs.hpp"

#include <span>
#include <string>
#include <vector>

namespace kfast {

/// Lines and the chip that has them.
struct FoundLines {
    GpioChip chip;
    std::vector<unsigned> offsets; ///< in the order of the lines asked for; no two are the same
};

/// As GpioOutputs has it. Throws Failure.
FoundLines find_lines(const std::string& chip, std::span<const GpioLine> lines);

}
