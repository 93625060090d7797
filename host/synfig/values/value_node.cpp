#include "host/synfig/values/value_node.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace kfast::synfig {

namespace {

Presence settled(bool on) { return {on ? 1.0 : 0.0, 0, 0}; }

}

Presence presence_at(const Entry& entry, double time)
{
    const auto& all = entry.switchings;
    if (all.empty())
        return settled(true);
    const auto next = std::ranges::lower_bound(all, time, {}, &Switching::time);
    if (next != all.end() && (next->time == time || next == all.begin()))
        return settled(next->on);
    const Switching& before = *std::prev(next);
    if (next == all.end() || next->on == before.on)
        return settled(before.on);
    const double share = (time - before.time) / (next->time - before.time);
    return next->on ? Presence{share, next->time, before.time} : Presence{1 - share, before.time, next->time};
}

namespace {

using Numbers = std::array<double, 4>;

Numbers numbers_of(const Value& value)
{
    if (const Vec2* spot = std::get_if<Vec2>(&value.held))
        return {spot->x, spot->y, 0, 0};
    if (const Colour* colour = std::get_if<Colour>(&value.held))
        return {colour->red, colour->green, colour->blue, colour->alpha};
    return {value.number(), 0, 0, 0};
}

Value value_like(const Value& example, const Numbers& numbers)
{
    if (std::holds_alternative<Vec2>(example.held))
        return {Vec2{numbers[0], numbers[1]}};
    if (std::holds_alternative<Colour>(example.held))
        return {Colour{numbers[0], numbers[1], numbers[2], numbers[3]}};
    return {numbers[0]};
}

/// Three values and their times; the tangent at the middle one does not overshoot the others.
double clamped_tangent(double before, double here, double after, double time_before, double time,
                       double time_after)
{
    const double low = std::min(before, after);
    const double high = std::max(before, after);
    if (here <= low || here >= high)
        return 0;
    const double even = before + (after - before) * (time - time_before) / (time_after - time_before);
    const double room = (here > even) == (after > before) ? after - even : even - before;
    const double bias = here == even ? 0 : (even - here) / room;
    return (here - before) * (1 + bias) / 2 + (after - here) * (1 - bias) / 2;
}

/// The tangents of one number, for the whole interval from a waypoint to the next.
class Tangents {
public:
    Tangents(const std::vector<Waypoint>& waypoints, std::size_t number) : points_{waypoints}, number_{number}
    {
    }

    double leaving(std::size_t index) const
    {
        const Interpolation kind = points_[index].after;
        if (kind == Interpolation::halt)
            return 0;
        const double raw = leaving_unadjusted(index);
        return kind == Interpolation::linear || index == 0 ? raw
                                                           : raw * adjusted(span(index), span(index - 1));
    }

    double arriving(std::size_t index) const
    {
        const Waypoint& next = points_[index + 1];
        const bool last = index + 2 == points_.size();
        if (next.before == Interpolation::automatic && next.after != Interpolation::automatic && !last &&
            !jumps(index + 1))
            return leaving_unadjusted(index + 1);
        if (next.before == Interpolation::halt)
            return 0;
        const double raw = arriving_unadjusted(index);
        return next.before == Interpolation::linear || last ? raw
                                                            : raw * adjusted(span(index), span(index + 1));
    }

private:
    double value(std::size_t index) const { return numbers_of(points_[index].value->constant)[number_]; }
    double span(std::size_t index) const { return points_[index + 1].time - points_[index].time; }
    double step(std::size_t index) const { return value(index + 1) - value(index); }
    bool jumps(std::size_t index) const
    {
        return points_[index].after == Interpolation::constant ||
               points_[index + 1].before == Interpolation::constant;
    }
    static double adjusted(double own, double other) { return 1.5 * own / (0.5 * own + other); }

    double leaving_unadjusted(std::size_t index) const
    {
        const Waypoint& point = points_[index];
        if (index == 0 || point.after == Interpolation::linear || point.after == Interpolation::halt)
            return step(index);
        if (point.after == Interpolation::clamped)
            return clamped(index);
        if (point.before != Interpolation::automatic)
            return jumps(index - 1) ? 0 : arriving(index - 1);
        const double loose = 1 - point.tension;
        return step(index - 1) * loose * (1 + point.continuity) * (1 + point.bias) / 2 +
               step(index) * loose * (1 - point.continuity) * (1 - point.bias) / 2;
    }

    double arriving_unadjusted(std::size_t index) const
    {
        const Waypoint& next = points_[index + 1];
        if (index + 2 == points_.size() || next.before == Interpolation::linear)
            return step(index);
        if (next.before == Interpolation::clamped)
            return clamped(index + 1);
        const double loose = 1 - next.tension;
        return step(index) * loose * (1 - next.continuity) * (1 + next.bias) / 2 +
               step(index + 1) * loose * (1 + next.continuity) * (1 - next.bias) / 2;
    }

    double clamped(std::size_t index) const
    {
        return clamped_tangent(value(index - 1), value(index), value(index + 1), points_[index - 1].time,
                               points_[index].time, points_[index + 1].time);
    }

    const std::vector<Waypoint>& points_;
    std::size_t number_;
};

double hermite(double from, double to, double leaving, double arriving, double share)
{
    const double square = 3 * (to - from) - 2 * leaving - arriving;
    const double cube = 2 * (from - to) + leaving + arriving;
    return from + share * (leaving + share * (square + share * cube));
}

std::size_t count_of_numbers(const Value& value)
{
    return std::holds_alternative<Vec2>(value.held) ? 2 : std::holds_alternative<Colour>(value.held) ? 4 : 1;
}

}

bool goes_smoothly(const Value& value)
{
    return std::holds_alternative<double>(value.held) || std::holds_alternative<Vec2>(value.held) ||
           std::holds_alternative<Colour>(value.held);
}

double warped_share(const Waypoint& from, const Waypoint& to, double share)
{
    return hermite(0, 1, 1 - from.temporal_tension, 1 - to.temporal_tension, share);
}

Value value_on_way(const std::vector<Waypoint>& waypoints, std::size_t index, double time)
{
    const Waypoint& from = waypoints[index];
    const Waypoint& to = waypoints[index + 1];
    const double share = warped_share(from, to, (time - from.time) / (to.time - from.time));
    const Numbers begin = numbers_of(from.value->constant);
    const Numbers end = numbers_of(to.value->constant);
    Numbers result{};
    for (std::size_t i = 0; i < count_of_numbers(from.value->constant); ++i) {
        const Tangents tangents{waypoints, i};
        result[i] = hermite(begin[i], end[i], tangents.leaving(index), tangents.arriving(index), share);
    }
    return value_like(from.value->constant, result);
}

}
