#include "host/preview/overlay/viewport.hpp"

#include "host/beam/beam_screen.hpp"

namespace kfast {
namespace {

constexpr int field_pixels = 1024; // any number will do: places are finer than pixels

double pixels(Fixed length) { return static_cast<double>(length.raw()) / Fixed::one; }

}

Size Viewport::posed_panel() const { return is_beam ? Size{field_pixels, field_pixels} : panel; }

PanelSpot Viewport::spot(Point posed) const
{
    const PanelSpot at{pixels(posed.x), pixels(posed.y)};
    if (!is_beam)
        return at;
    const double scale = BeamScreen::field_side_on(panel) / field_pixels;
    const double middle = field_pixels / 2.0;
    return {panel.width / 2.0 + (at.x - middle) * scale, panel.height / 2.0 + (at.y - middle) * scale};
}

}
