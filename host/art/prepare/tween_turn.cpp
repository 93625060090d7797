#include "host/art/prepare/tween_turn.hpp"

#include "host/art/animation/ease_part.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace kfast::art {
namespace {

using scene::Vec2;

/// a + b s + c s² between two s.
struct Parabola {
    double a = 0;
    double b = 0;
    double c = 0;

    double at(double s) const { return a + s * (b + s * c); }

    template <typename Visit>
    void every_extreme(double low, double high, const Visit& visit) const
    {
        visit(at(low));
        visit(at(high));
        if (c != 0 && -b / (2 * c) > low && -b / (2 * c) < high)
            visit(at(-b / (2 * c)));
    }
    double min(double low, double high) const
    {
        double result = at(low);
        every_extreme(low, high, [&](double value) { result = std::min(result, value); });
        return result;
    }
    double greatest_amount(double low, double high) const
    {
        double result = 0;
        every_extreme(low, high, [&](double value) { result = std::max(result, std::abs(value)); });
        return result;
    }
};

Parabola dot(const TweenedVector& left, const TweenedVector& right)
{
    return {dot(left.begin, right.begin), dot(left.begin, right.way) + dot(left.way, right.begin),
            dot(left.way, right.way)};
}

Parabola cross(const TweenedVector& left, const TweenedVector& right)
{
    return {cross(left.begin, right.begin), cross(left.begin, right.way) + cross(left.way, right.begin),
            cross(left.way, right.way)};
}

bool vanishes(Vec2 vector) { return dot(vector, vector) < 1e-18; }

double angle(Vec2 left, Vec2 right) { return std::atan2(std::abs(cross(left, right)), dot(left, right)); }

}

double greatest_turn(const TweenedVector& left, const TweenedVector& right, double low, double high)
{
    // Two that vanish together keep their angle all along.
    if (vanishes(left.begin) && vanishes(right.begin) && !vanishes(left.way) && !vanishes(right.way))
        return angle(left.way, right.way);
    if (vanishes(left.end()) && vanishes(right.end()) && !vanishes(left.begin) && !vanishes(right.begin))
        return angle(left.begin, right.begin);
    const double lengths = shortest(left, low, high) * shortest(right, low, high);
    const double sine = cross(left, right).greatest_amount(low, high);
    if (!(sine < lengths) || !(dot(left, right).min(low, high) > 0))
        return std::numbers::pi;
    return std::asin(sine / lengths);
}

double shortest(const TweenedVector& vector, double low, double high)
{
    return std::sqrt(std::max(0.0, dot(vector, vector).min(low, high)));
}

std::vector<TweenRange> tweens_of(const Animated<Drawing>& drawing)
{
    if (drawing.is_still())
        return {{0, 0, 0, 0}};
    std::vector<TweenRange> tweens;
    for (std::size_t i = 0; i + 1 < drawing.keys.size(); ++i) {
        const ProgressRange range = progress_range(drawing.keys[i].ease);
        tweens.push_back({i, i + 1, range.low, range.high});
    }
    return tweens;
}

double tween_growth(std::span<const TweenRange> tweens)
{
    double max = 1;
    for (const TweenRange& tween : tweens)
        max = std::max({max, 1 - 2 * tween.low, 2 * tween.high - 1});
    return max;
}

double greatest_turn(std::span<const Vec2> left, std::span<const Vec2> right,
                     std::span<const TweenRange> tweens)
{
    double max = 0;
    for (const TweenRange& tween : tweens)
        max =
            std::max(max, greatest_turn(TweenedVector{left[tween.from], left[tween.to] - left[tween.from]},
                                        TweenedVector{right[tween.from], right[tween.to] - right[tween.from]},
                                        tween.low, tween.high));
    return max;
}

double shortest(std::span<const Vec2> vectors, std::span<const TweenRange> tweens)
{
    double min = std::numeric_limits<double>::infinity();
    for (const TweenRange& tween : tweens)
        min = std::min(min,
                       shortest(TweenedVector{vectors[tween.from], vectors[tween.to] - vectors[tween.from]},
                                tween.low, tween.high));
    return min;
}

}
