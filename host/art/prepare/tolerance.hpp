#pragma once

namespace kfast::art {

/// How far simplification may move anything that is seen, in canvas pixels.
inline constexpr double default_tolerance = 1.0 / 32;

}
