#pragma once

#include "core/point.hpp"
#include "core/size.hpp"

#include <cstdint>

namespace kfast {

/// How the canvas is laid on a panel of another size; always centred.
enum class Fit : std::uint8_t {
    contain, ///< as large as fits whole, background around it
    cover,   ///< as small as fills the panel, the rest is cut off
    none,    ///< one canvas pixel is one panel pixel
};

/// From canvas to panel coordinates: one scale for both axes, then a shift.
class CanvasMap {
public:
    /// The sides are 1 … 4096 pixels long.
    CanvasMap(Size canvas, Size panel, Fit fit);

    /// Rounded to 1/65536 px. Points further than 16383 px away from the origin are moved there, so that the
    /// differences of mapped coordinates fit in Fixed.
    Point operator()(Point on_canvas) const;
    /// Half the width of a stroke, rounded to 1/65536 px; at most 4095 px, so that the tip of a miter, four
    /// times as far from its corner, fits in Fixed too.
    Fixed half_width(Fixed on_canvas) const;

private:
    Fixed scale_;
    std::int64_t shift_x_; ///< in 1/65536 px: what covers a panel of another shape reaches far beyond Fixed
    std::int64_t shift_y_;
};

}
