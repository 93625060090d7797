#include "host/art/prepare/corner_arms.hpp"

#include "host/art/geometry/cubic_piece.hpp"

#include <algorithm>
#include <numbers>
#include <utility>

namespace kfast::art {
namespace {

using scene::Outline;
using scene::Vec2;

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
        // Both may turn.
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
        // It turns by at most twice the motion divided by its length.
        max = std::max(max, 1 + 2 * arm.factor * half_width / shortest(arm.directions, tweens));
    return max;
}

}
