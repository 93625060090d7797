#pragma once

#include "core/raster/outline/paint_step.hpp"

#include <span>

namespace kfast::raster {

/// Finds the steps of two pictures that stand for the same thing, in the order of both, and notes each as the
/// partner of the other.
void match(std::span<PaintStep> shown, std::span<PaintStep> next);

}
