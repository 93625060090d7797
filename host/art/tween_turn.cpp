#include "host/art/tween_turn.hpp"

#include "host/art/ease_part.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace kfast::art {
namespace {

using scene::Spot;

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
    double least(double low, double high) const
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

/// Of two vectors that go straight.
struct Tween {
    Spot begin;
    Spot way;
};

Parabola dot(const Tween& left, const Tween& right)
{
    return {dot(left.begin, right.begin), dot(left.begin, right.way) + dot(left.way, right.begin),
            dot(left.way, right.way)};
}

Parabola cross(const Tween& left, const Tween& right)
{
    return {cross(left.begin, right.begin), cross(left.begin, right.way) + cross(left.way, right.begin),
            cross(left.way, right.way)};
}

double greatest_turn(const Tween& left, const Tween& right, const TweenRange& tween)
{
    const double lengths = std::sqrt(std::max(0.0, dot(left, left).least(tween.low, tween.high)) *
                                     std::max(0.0, dot(right, right).least(tween.low, tween.high)));
    const double sine = cross(left, right).greatest_amount(tween.low, tween.high);
    if (!(sine < lengths) || !(dot(left, right).least(tween.low, tween.high) > 0))
        return std::numbers::pi;
    return std::asin(sine / lengths);
}

}

std::vector<TweenRange> tweens_of(const Animated<Drawing>& drawing)
{
    if (drawing.is_still())
        return {{0, 0, 0, 0}};
    std::vector<TweenRange> tweens;
    for (std::size_t i = 0; i + 1 < drawing.keys.size(); ++i) {
        const WayRange range = way_range(drawing.keys[i].ease);
        tweens.push_back({i, i + 1, range.low, range.high});
    }
    return tweens;
}

double tween_growth(std::span<const TweenRange> tweens)
{
    double most = 1;
    for (const TweenRange& tween : tweens)
        most = std::max({most, 1 - 2 * tween.low, 2 * tween.high - 1});
    return most;
}

double greatest_turn(std::span<const Spot> left, std::span<const Spot> right,
                     std::span<const TweenRange> tweens)
{
    double most = 0;
    for (const TweenRange& tween : tweens)
        most = std::max(most, greatest_turn({left[tween.from], left[tween.to] - left[tween.from]},
                                            {right[tween.from], right[tween.to] - right[tween.from]}, tween));
    return most;
}

double shortest(std::span<const Spot> vectors, std::span<const TweenRange> tweens)
{
    double least = std::numeric_limits<double>::infinity();
    for (const TweenRange& tween : tweens) {
        const Tween vector{vectors[tween.from], vectors[tween.to] - vectors[tween.from]};
        least = std::min(least, dot(vector, vector).least(tween.low, tween.high));
    }
    return std::sqrt(std::max(0.0, least));
}

}
