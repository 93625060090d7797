#include "core/canvas_map.hpp"

#include "core/stroke_style.hpp"

#include <algorithm>

namespace kfast {
namespace {

constexpr std::int64_t furthest = Fixed::pixels(16383).raw();
constexpr std::int64_t widest = Fixed::pixels(4095).raw();
static_assert(furthest + miter_limit * widest <= Fixed::pixels(32767).raw());

Fixed limited(std::int64_t raw, std::int64_t limit)
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

std::int64_t centring(int canvas, int panel, Fixed scale)
{
    return (std::int64_t{panel} * Fixed::one - std::int64_t{canvas} * scale.raw()) / 2;
}

}

CanvasMap::CanvasMap(Size canvas, Size panel, Fit fit)
    : scale_{scale_for(canvas, panel, fit)}, shift_x_{centring(canvas.width, panel.width, scale_)},
      shift_y_{centring(canvas.height, panel.height, scale_)}
{
}

Point CanvasMap::operator()(Point on_canvas) const
{
    return {limited(product(on_canvas.x, scale_) + shift_x_, furthest),
            limited(product(on_canvas.y, scale_) + shift_y_, furthest)};
}

Fixed CanvasMap::half_width(Fixed on_canvas) const { return limited(product(on_canvas, scale_), widest); }

}
