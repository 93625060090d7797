#pragma once

#include <numbers>

namespace kfast::art {

/// In radians.
inline constexpr double degree = std::numbers::pi / 180;

}
