#include "host/art/prepare/tween_turn.hpp"

#include "host/art/animation/ease.hpp"
#include "host/art/geometry/curves.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

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

namespace {

using scene::Outline;

/// Up to that many radians between two arms, the line has no tip.
constexpr double smooth_turn = 0.5;

CubicPiece piece(const Outline& outline, std::size_t index)
{
    const Vec2 from = index == 0 ? outline.from : outline.curves[index - 1].to;
    const scene::Curve curve = as_cubic(from, outline.curves[index]);
    return {{from, curve.c1, curve.c2, curve.to}};
}

/// Collects the arms of one outline in all keys.
class OutlineArms {
public:
    OutlineArms(const Animated<Drawing>& drawing, std::size_t outline, double corner_factor)
        : drawing_{drawing}, outline_{outline}, corner_factor_{corner_factor}, tweens_{tweens_of(drawing)}
    {
    }

    void add_corners(std::vector<CornerArm>& arms) const
    {
        for (std::size_t i = 1; i < form().curves.size(); ++i)
            add_corner(arriving(i - 1), setting_out(i), arms);
        if (!form().closed)
            return;
        const auto closing =
            each([](const Outline& outline) { return outline.from - outline.curves.back().to; });
        const bool has_line = std::ranges::any_of(closing, [](Vec2 way) { return dot(way, way) > 0; });
        if (has_line) {
            add_corner(arriving(form().curves.size() - 1), closing, arms);
            add_corner(closing, setting_out(0), arms);
        } else {
            add_corner(arriving(form().curves.size() - 1), setting_out(0), arms);
        }
    }

    void add_ends(double factor, std::vector<CornerArm>& arms) const
    {
        arms.push_back({setting_out(0), factor});
        arms.push_back({arriving(form().curves.size() - 1), factor});
    }

private:
    const Outline& form() const { return drawing_.keys.front().value.outlines[outline_]; }

    template <typename Direction>
    std::vector<Vec2> each(const Direction& direction) const
    {
        std::vector<Vec2> list;
        list.reserve(drawing_.keys.size());
        for (const auto& key : drawing_.keys)
            list.push_back(direction(key.value.outlines[outline_]));
        return list;
    }
    std::vector<Vec2> setting_out(std::size_t segment) const
    {
        return each([&](const Outline& outline) { return piece(outline, segment).first_direction(); });
    }
    std::vector<Vec2> arriving(std::size_t segment) const
    {
        return each([&](const Outline& outline) { return piece(outline, segment).last_direction(); });
    }

    void add_corner(std::vector<Vec2> before, std::vector<Vec2> behind, std::vector<CornerArm>& arms) const
    {
        if (greatest_turn(before, behind, tweens_) <= smooth_turn)
            return;
        // Both may rotate.
        arms.push_back({std::move(before), 2 * corner_factor_});
        arms.push_back({std::move(behind), 2 * corner_factor_});
    }

    const Animated<Drawing>& drawing_;
    std::size_t outline_;
    double corner_factor_;
    std::vector<TweenRange> tweens_;
};

}

std::vector<CornerArm> corner_arms(const Shape& shape)
{
    std::vector<CornerArm> arms;
    if (!shape.stroke)
        return arms;
    const StrokeStyle& stroke = *shape.stroke;
    const double longest = stroke.join == Join::miter ? std::max(1.0, stroke.miter_limit) : 1;
    const Drawing& form = shape.drawing.keys.front().value;
    for (std::size_t i = 0; i < form.outlines.size(); ++i) {
        if (form.outlines[i].curves.empty())
            continue;
        const OutlineArms outline{shape.drawing, i, longest * longest};
        if (stroke.join != Join::round)
            outline.add_corners(arms);
        if (stroke.cap != Cap::round && !form.outlines[i].closed)
            outline.add_ends(stroke.cap == Cap::square ? std::numbers::sqrt2 : 1, arms);
    }
    return arms;
}

double corner_motion(std::span<const CornerArm> arms, std::span<const TweenRange> tweens, double half_width)
{
    double max = 1;
    for (const CornerArm& arm : arms)
        // It rotates by at most twice the motion divided by its length.
        max = std::max(max, 1 + 2 * arm.factor * half_width / shortest(arm.directions, tweens));
    return max;
}

}
