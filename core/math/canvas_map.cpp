#include "core/math/canvas_map.hpp"

namespace kfast {
namespace {

/// to / from in Q16, rounded to nearest; both are sides of canvases and panels.
std::int32_t ratio(int to, int from)
{
    const auto divisor = static_cast<std::uint32_t>(from);
    return static_cast<std::int32_t>((static_cast<std::uint32_t>(to) * Fixed::one + divisor / 2) / divisor);
}

std::int32_t scale_for(Size canvas, Size panel, Fit fit)
{
    if (fit == Fit::none)
        return Fixed::one;
    const bool is_wider = canvas.width * panel.height > panel.width * canvas.height;
    return is_wider == (fit == Fit::contain) ? ratio(panel.width, canvas.width)
                                             : ratio(panel.height, canvas.height);
}

std::int64_t centring(int canvas, int panel, std::int32_t scale)
{
    return (std::int64_t{panel} * Fixed::one - std::int64_t{canvas} * scale) / 2;
}

}

Affine canvas_map(Size canvas, Size panel, Fit fit)
{
    const std::int32_t scale = scale_for(canvas, panel, fit);
    return {.xx = scale,
            .yy = scale,
            .x0 = centring(canvas.width, panel.width, scale),
            .y0 = centring(canvas.height, panel.height, scale)};
}

}
