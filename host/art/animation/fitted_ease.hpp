#pragma once

#include "host/art/animation/ease.hpp"

#include <optional>
#include <span>

namespace kfast::art {

/// The cubic ease that goes nearly as `ways` do, shares of the way at times evenly spread from 0 to 1, the
/// first and the last one included: the best in the sense of least squares, near enough. Within the bounds of
/// the scene's language, and rounded to its 1/8192. Nothing if there are fewer than five.
std::optional<Ease> fitted_ease(std::span<const double> ways);

}
