#pragma once

#include "host/art/animation/ease.hpp"

#include <optional>
#include <span>

namespace kfast::art {

/// The cubic ease that approximates `ways`, the progress at times evenly spread from 0 to 1, the first and
/// the last one included: nearly the best in the sense of least squares. Within the bounds of the scene
/// language, and rounded to its 1/8192. Nothing if there are fewer than five.
std::optional<Ease> fitted_ease(std::span<const double> ways);

}
