#include "host/art/corner_motion.hpp"

#include "host/art/cubic_piece.hpp"
#include "host/art/extent.hpp"
#include "host/art/tween_turn.hpp"

#include <algorithm>
#include <limits>

namespace kfast::art {
namespace {

using scene::Outline;
using scene::Spot;

/// Up to that many radians between two arms, the line has no tip.
constexpr double smooth_turn = 0.5;

constexpr double endless = std::numeric_limits<double>::infinity();

CubicPiece piece(const Outline& outline, std::size_t index)
{
    const Spot from = index == 0 ? outline.from : outline.curves[index - 1].to;
    const scene::Curve curve = as_cubic(from, outline.curves[index]);
    return {{from, curve.c1, curve.c2, curve.to}};
}

/// The directions of one outline in all keys.
class Directions {
public:
    Directions(const Animated<Drawing>& drawing, std::size_t outline) : drawing_{drawing}, outline_{outline}
    {
    }

    std::vector<Spot> setting_out(std::size_t segment) const
    {
        return each([&](const Outline& outline) { return piece(outline, segment).first_direction(); });
    }
    std::vector<Spot> arriving(std::size_t segment) const
    {
        return each([&](const Outline& outline) { return piece(outline, segment).last_direction(); });
    }

private:
    template <typename Direction>
    std::vector<Spot> each(const Direction& direction) const
    {
        std::vector<Spot> list;
        for (const auto& key : drawing_.keys)
            list.push_back(direction(key.value.outlines[outline_]));
        return list;
    }

    const Animated<Drawing>& drawing_;
    std::size_t outline_;
};

/// The shortest of two arms where they meet at a corner; endless where the outline goes on smoothly.
double corner_arm(const std::vector<Spot>& before, const std::vector<Spot>& behind,
                  std::span<const TweenRange> tweens)
{
    if (greatest_turn(before, behind, tweens) <= smooth_turn)
        return endless;
    return std::min(shortest(before, tweens), shortest(behind, tweens));
}

double shortest_corner_arm(const Directions& directions, const Outline& form,
                           std::span<const TweenRange> tweens)
{
    double arm = endless;
    for (std::size_t i = 1; i < form.curves.size(); ++i)
        arm = std::min(arm, corner_arm(directions.arriving(i - 1), directions.setting_out(i), tweens));
    return arm;
}

/// Where an outline begins and ends: a cap, or a corner that may have a line of its own.
double shortest_end_arm(const Directions& directions, const Outline& form, std::span<const TweenRange> tweens)
{
    const auto first = directions.setting_out(0);
    const auto last = directions.arriving(form.curves.size() - 1);
    return std::min(shortest(first, tweens), shortest(last, tweens));
}

}

double corner_motion(const Figure& figure)
{
    if (!figure.line || (figure.line->join == Join::round && figure.line->cap == Cap::round))
        return 1;
    const Line& line = *figure.line;
    const auto tweens = tweens_of(figure.drawing);
    const double longest = line.join == Join::miter ? std::max(1.0, line.miter_limit) : 1;
    // An arm turns by at most twice the motion divided by its length, and there are two of them.
    const double turning = 4 * longest * longest * greatest(line.width) / 2;
    double most = 1;
    const Drawing& form = figure.drawing.keys.front().value;
    for (std::size_t i = 0; i < form.outlines.size(); ++i) {
        if (form.outlines[i].curves.empty())
            continue;
        const Directions directions{figure.drawing, i};
        const double arm = std::min(shortest_corner_arm(directions, form.outlines[i], tweens),
                                    shortest_end_arm(directions, form.outlines[i], tweens));
        most = std::max(most, 1 + turning / arm);
    }
    return most;
}

}
