#include "core/canvas_map.hpp"

#include <algorithm>

namespace kfast {
namespace {

constexpr std::int64_t limit = Fixed::pixels(16383).raw();

Fixed limited(std::int64_t raw)
{
    return Fixed::from_raw(static_cast<std::int32_t>(std::clamp(raw, -limit, limit)));
}

std::int64_t product(Fixed a, Fixed b) { return (std::int64_t{a.raw()} * b.raw() + Fixed::one / 2) >> 16; }

/// to / from, rounded to nearest.
Fixed ratio(int to, int from)
{
    return Fixed::from_raw(static_cast<std::int32_t>((std::int64_t{to} * Fixed::one + from / 2) / from));
}

Fixed scale_for(Size canvas, Size panel, Fit fit)
{
    if (fit == Fit::none)
        return Fixed::pixels(1);
    const bool is_wider = canvas.width * panel.height > panel.width * canvas.height;
    return is_wider == (fit == Fit::contain) ? ratio(panel.width, canvas.width)
                                             : ratio(panel.height, canvas.height);
}

Fixed centring(int canvas, int panel, Fixed scale)
{
    return limited((std::int64_t{panel} * Fixed::one - std::int64_t{canvas} * scale.raw()) / 2);
}

}

CanvasMap::CanvasMap(Size canvas, Size panel, Fit fit)
    : scale_{scale_for(canvas, panel, fit)}, shift_{centring(canvas.width, panel.width, scale_),
                                                    centring(canvas.height, panel.height, scale_)}
{
}

Point CanvasMap::operator()(Point on_canvas) const
{
    return {limited(product(on_canvas.x, scale_) + shift_.x.raw()),
            limited(product(on_canvas.y, scale_) + shift_.y.raw())};
}

Fixed CanvasMap::scaled(Fixed length) const { return limited(product(length, scale_)); }

}
