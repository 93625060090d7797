#pragma once

#include "host/lottie/drawings/extent.hpp"

namespace kfast::lottie {

/// How much of something is covered.
enum class Coverage { all, nothing, part };

Coverage inverted(Coverage coverage);

/// Of a box by a filled drawing.
Coverage coverage_of(const Box& box, const art::Drawing& drawing);

/// Of a polygon by what nodes paint without being seen through; if `by_luminance`, by white without it.
Coverage coverage_of(std::span<const scene::Vec2> polygon, std::span<const art::Node> nodes,
                     const art::Affine& matrix, double time, bool by_luminance);

}
