#pragma once

#include "host/config/wiring.hpp"

#include <span>
#include <string>

namespace kfast::config {

/// A Pico from above in letters, its USB socket on top, with what goes to each pin beside it.
std::string pico_drawing(std::span<const Connection> wires);

}
