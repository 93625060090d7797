#pragma once

#include "core/math/fixed.hpp"

#include <string>

namespace kfast {

/// A length as SVG writes it, with at most four digits behind the point: sixteenths are exact, the rest is
/// rounded to nearest, halves away from 0.
std::string svg_number(Fixed length);

/// 0 … 255 as 0 … 1, with at most four digits.
std::string svg_share(std::uint32_t opacity);

}
