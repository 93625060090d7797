#include "host/scene_text/drawings/steady_form.hpp"

#include "host/scene_text/values/grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace kfast::scene_text {
namespace {

using art::Drawing;
using scene::Curve;
using scene::Outline;
using scene::Vec2;

constexpr double step = 1.0 / 16;

bool equal(Vec2 left, Vec2 right) { return left.x == right.x && left.y == right.y; }

bool has_extent(Vec2 from, const Curve& curve)
{
    return !equal(curve.to, from) || (curve.cubic && (!equal(curve.c1, from) || !equal(curve.c2, from)));
}

/// The point that a curve first heads for from `from`, if it has an extent.
Vec2 heading(Vec2 from, const Curve& curve)
{
    if (curve.cubic && !equal(curve.c1, from))
        return curve.c1;
    return curve.cubic && !equal(curve.c2, from) ? curve.c2 : curve.to;
}

/// The point that it comes from at its end.
Vec2 origin(Vec2 from, const Curve& curve)
{
    if (curve.cubic && !equal(curve.c2, curve.to))
        return curve.c2;
    return curve.cubic && !equal(curve.c1, curve.to) ? curve.c1 : from;
}

/// Moved that many steps towards `goal`; different for different counts.
Vec2 stepped(Vec2 from, Vec2 goal, std::size_t steps)
{
    const Vec2 way = goal - from;
    const double longest = std::max(std::abs(way.x), std::abs(way.y));
    const double share = longest > 0 ? static_cast<double>(steps) * step / longest : 0;
    return {snapped(from.x + share * way.x, coordinates), snapped(from.y + share * way.y, coordinates)};
}

/// Moves the ends of segments without extent in one outline.
class Segments {
public:
    explicit Segments(Outline& outline) : outline_{outline}, curves_{outline.curves} {}

    void keep()
    {
        for (std::size_t i = 0; i < curves_.size(); ++i)
            if (!has_extent(start_of(i), curves_[i]))
                i = keep_run(i);
    }

private:
    Vec2 start_of(std::size_t i) const { return i == 0 ? outline_.from : curves_[i - 1].to; }

    /// Moves a run from its first segment without extent on; returns the last.
    std::size_t keep_run(std::size_t first)
    {
        const Vec2 place = start_of(first);
        std::size_t last = first;
        while (last + 1 < curves_.size() && !has_extent(place, curves_[last + 1]))
            ++last;
        const std::size_t count = last - first + 1;
        if (last + 1 < curves_.size())
            spread_forward(first, last, heading(place, curves_[last + 1]));
        else if (first > 0)
            spread_back(first, count, origin(start_of(first - 1), curves_[first - 1]));
        else
            spread_alone(place);
        for (std::size_t i = first; i <= last; ++i)
            straighten(i);
        return last;
    }

    void spread_forward(std::size_t first, std::size_t last, Vec2 goal)
    {
        const Vec2 place = start_of(first);
        for (std::size_t i = first; i <= last; ++i)
            curves_[i].to = stepped(place, goal, i - first + 1);
        if (!has_extent(curves_[last].to, curves_[last + 1])) // that was too short
            curves_[last].to = stepped(place, place - (goal - place), 1);
    }

    /// The last point stays, for the outline may be closed there.
    void spread_back(std::size_t first, std::size_t count, Vec2 goal)
    {
        const Vec2 place = curves_.back().to;
        for (std::size_t i = 0; i < count; ++i)
            curves_[first - 1 + i].to = stepped(place, goal, count - i);
        if (!has_extent(start_of(first - 1), curves_[first - 1]))
            curves_[first - 1].to = stepped(place, place - (goal - place), count);
    }

    /// For an outline all of whose points coincide.
    void spread_alone(Vec2 place)
    {
        const Vec2 beside{snapped(place.x + (place.x < 0 ? step : -step), coordinates), place.y};
        const Vec2 below{place.x, snapped(place.y + (place.y < 0 ? step : -step), coordinates)};
        for (std::size_t i = 0; i + 1 < curves_.size(); ++i)
            curves_[i].to = i % 2 == 0 ? beside : place;
        if (curves_.size() > 1 && curves_.size() % 2 == 1)
            curves_[curves_.size() - 2].to = below;
        if (curves_.size() == 1)
            curves_.front() = scene::cubic_to(beside, place, place);
    }

    void straighten(std::size_t i)
    {
        Curve& curve = curves_[i];
        if (!curve.cubic || curves_.size() == 1)
            return;
        curve.c1 = start_of(i);
        curve.c2 = curve.to;
    }

    Outline& outline_;
    std::vector<Curve>& curves_;
};

bool has_gap(const Outline& outline)
{
    return outline.closed && !outline.curves.empty() && !equal(outline.curves.back().to, outline.from);
}

void close_gaps(std::span<Drawing* const> drawings, std::size_t outline)
{
    const auto gapes = [outline](const Drawing* drawing) { return has_gap(drawing->outlines[outline]); };
    if (std::ranges::none_of(drawings, gapes))
        return;
    for (Drawing* const drawing : drawings) {
        Outline& closed = drawing->outlines[outline];
        closed.curves.push_back(scene::line_to(closed.from));
    }
}

}

void keep_segments(std::span<Drawing* const> drawings)
{
    const auto fits = [&](const Drawing* drawing) { return same_form(*drawing, *drawings.front()); };
    if (std::ranges::all_of(drawings, fits))
        for (std::size_t i = 0; i < drawings.front()->outlines.size(); ++i)
            close_gaps(drawings, i);
    for (Drawing* const drawing : drawings)
        for (Outline& outline : drawing->outlines)
            Segments{outline}.keep();
}

void keep_open(Drawing& drawing)
{
    for (Outline& outline : drawing.outlines) {
        if (outline.closed || outline.curves.size() < 2 || !equal(outline.curves.back().to, outline.from))
            continue;
        Curve& last = outline.curves.back();
        last.to = stepped(last.to, origin(outline.curves[outline.curves.size() - 2].to, last), 1);
    }
}

}
