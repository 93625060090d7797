#pragma once

#include "core/math/affine.hpp"
#include "core/math/point.hpp"

#include <cstdint>

namespace kfast {

/// How the canvas is laid on a panel of another size; always centred.
enum class Fit : std::uint8_t {
    contain, ///< as large as fits whole, background around it
    cover,   ///< as small as fills the panel, the rest is cut off
    none,    ///< one canvas pixel is one panel pixel
};

/// From canvas to panel coordinates: one scale for both axes, rounded to 1/65536, then a shift. The sides are
/// 1 … 4096 pixels long.
Affine canvas_map(Size canvas, Size panel, Fit fit);

}
