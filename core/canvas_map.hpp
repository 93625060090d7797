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
    /// A length, rounded to 1/65536 px; at most 16383 px.
    Fixed scaled(Fixed length) const;

private:
    Fixed scale_;
    Point shift_;
};

}
