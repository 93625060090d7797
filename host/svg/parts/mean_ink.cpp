#include "host/svg/parts/mean_ink.hpp"

#include "host/art/geometry/curve_length.hpp"

#include <algorithm>
#include <cmath>

namespace kfast::svg {
namespace {

using art::Affine;
using scene::Vec2;

/// Twice of it, by its direction; curves as 8 lines.
double signed_area(const scene::Outline& outline)
{
    constexpr int steps = 8;
    double sum = 0;
    Vec2 last = outline.from;
    Vec2 from = outline.from;
    for (const scene::Curve& curve : outline.curves) {
        for (int step = 1; step <= steps; ++step) {
            const Vec2 next = art::spot_on(from, curve, static_cast<double>(step) / steps);
            sum += scene::cross(last - outline.from, next - outline.from);
            last = next;
        }
        from = curve.to;
    }
    return sum;
}

double fill_area(const art::Drawing& drawing)
{
    double sum = 0;
    for (const scene::Outline& outline : drawing.outlines)
        sum += signed_area(outline);
    return std::abs(sum) / 2;
}

double line_area(const art::Drawing& drawing, double width)
{
    double length = 0;
    for (const scene::Outline& outline : drawing.outlines)
        length += art::outline_length(outline);
    return length * width;
}

class Spread {
public:
    explicit Spread(double tile) : tile_{tile} {}

    void add(const Part& part, double area_factor, double opacity)
    {
        area_factor *= std::abs(part.own.determinant());
        opacity *= part.opacity;
        if (part.fill)
            add(*part.fill, area_factor * fill_area(part.drawing), opacity);
        if (part.pen)
            add(part.pen->ink, area_factor * line_area(part.drawing, part.pen->width), opacity);
        for (const Part& inner : part.parts)
            add(inner, area_factor, opacity);
    }

    const Ink& ink() const { return ink_; }

private:
    /// Over what is there.
    void add(const Ink& ink, double area, double opacity)
    {
        const double share = std::min(area / tile_, 1.0) * ink.opacity * opacity;
        const double sum = share + ink_.opacity * (1 - share);
        if (!(sum > 0))
            return;
        ink_ = {art::mixed(ink_.colour, ink.colour, share / sum), std::min(sum, 1.0)};
    }

    double tile_;
    Ink ink_{{}, 0};
};

}

std::optional<Ink> mean_ink(std::span<const Part> parts, double tile)
{
    Spread spread{tile};
    for (const Part& part : parts)
        spread.add(part, 1, 1);
    return tile > 0 && spread.ink().opacity > 0 ? std::optional{spread.ink()} : std::nullopt;
}

}
