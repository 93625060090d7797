#include "core/beam/nearest_neighbour.hpp"

#include "core/beam/beam_profile.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace kfast {
namespace {

/// A leg, and how far away its beginning is.
struct Approach {
    std::int32_t travel = std::numeric_limits<std::int32_t>::max();
    BeamLeg leg;

    void take_nearer(const Approach& other)
    {
        if (other.travel < travel)
            *this = other;
    }
};

/// Checks some of its points, from the first one on.
Approach approach_closed(const BeamLines& lines, FieldPoint from, std::uint16_t line)
{
    constexpr int looked_at = 8;
    const std::span<const FieldPoint> points = lines.points(lines.line(line));
    const std::size_t step = points.size() / looked_at + 1;
    Approach nearest;
    for (std::size_t point = 0; point + 1 < points.size(); point += step)
        nearest.take_nearer({beam_travel(from, points[point]), {line, static_cast<std::uint16_t>(point)}});
    return nearest;
}

Approach approach_line(const BeamLines& lines, FieldPoint from, std::uint16_t line)
{
    if (lines.is_closed(lines.line(line)))
        return approach_closed(lines, from, line);
    const std::span<const FieldPoint> points = lines.points(lines.line(line));
    Approach nearest{beam_travel(from, points.front()), {line}};
    nearest.take_nearer({beam_travel(from, points.back()), {line, 0, true}});
    return nearest;
}

/// The lines of an item as one leg: `line` is the first of them, `start` how many follow it.
struct ItemChain {
    static FieldPoint begin_of(const BeamLines& lines, const BeamLeg& chain)
    {
        return lines.points(lines.line(chain.line)).front();
    }

    static FieldPoint end_of(const BeamLines& lines, const BeamLeg& chain)
    {
        return lines.points(lines.line(chain.line + std::size_t{chain.start})).back();
    }
};

Approach approach_chain(const BeamLines& lines, FieldPoint from, const BeamLeg& chain)
{
    Approach nearest{beam_travel(from, ItemChain::begin_of(lines, chain)), {chain.line, chain.start}};
    nearest.take_nearer(
        {beam_travel(from, ItemChain::end_of(lines, chain)), {chain.line, chain.start, true}});
    return nearest;
}

/// Where following `chain`, which may be reversed, ends.
FieldPoint far_end_of(const BeamLines& lines, const BeamLeg& chain)
{
    return chain.is_reversed ? ItemChain::begin_of(lines, chain) : ItemChain::end_of(lines, chain);
}

/// approach(from, leg) is the best approach to `leg`, end_of(leg) where it ends.
template <class ApproachTo, class EndOf>
void follow_nearest(FieldPoint from, std::size_t window, std::span<BeamLeg> legs, ApproachTo approach,
                    EndOf end_of)
{
    for (std::size_t i = 0; i < legs.size(); ++i) {
        Approach nearest;
        std::size_t place = i;
        const std::size_t bound = std::min(legs.size(), i + window);
        for (std::size_t j = i; j < bound; ++j) {
            const Approach other = approach(from, legs[j]);
            if (other.travel < nearest.travel) {
                nearest = other;
                place = j;
            }
        }
        std::swap(legs[i], legs[place]);
        legs[i] = nearest.leg;
        from = end_of(legs[i]);
    }
}

/// The number of chains that fill the beginning of `legs`; none if there are more than `max`.
std::size_t find_chains(const BeamLines& lines, std::size_t max, std::span<BeamLeg> legs)
{
    std::size_t count = 0;
    for (std::size_t number = 0; number < lines.size(); ++number) {
        if (number != 0 && lines.line(number).item == lines.line(number - 1).item) {
            ++legs[count - 1].start;
            continue;
        }
        if (count == max)
            return 0;
        legs[count++] = {static_cast<std::uint16_t>(number)};
    }
    return count;
}

/// Replaces the first `count` legs, which are chains, by their lines: from the back, so that no
/// chain is overwritten before it is read.
void unfold(const BeamLines& lines, std::size_t count, std::span<BeamLeg> legs)
{
    std::size_t place = legs.size();
    while (count > 0) {
        const BeamLeg chain = legs[--count];
        for (std::size_t i = 0; i <= chain.start; ++i) {
            const std::size_t from_first = chain.is_reversed ? i : chain.start - i;
            const BeamLeg leg{static_cast<std::uint16_t>(chain.line + from_first)};
            legs[--place] = chain.is_reversed ? reversed(lines, leg) : leg;
        }
    }
}

}

void follow_nearest_lines(const BeamLines& lines, FieldPoint from, std::size_t window,
                          std::span<BeamLeg> legs)
{
    follow_nearest(
        from, window, legs,
        [&](FieldPoint at, const BeamLeg& leg) { return approach_line(lines, at, leg.line); },
        [&](const BeamLeg& leg) { return end_of(lines, leg); });
}

bool follow_nearest_items(const BeamLines& lines, FieldPoint from, std::size_t max_items,
                          std::span<BeamLeg> legs)
{
    const std::size_t count = find_chains(lines, max_items, legs);
    if (count == 0 || count == legs.size())
        return false;
    follow_nearest(
        from, count, legs.first(count),
        [&](FieldPoint at, const BeamLeg& chain) { return approach_chain(lines, at, chain); },
        [&](const BeamLeg& chain) { return far_end_of(lines, chain); });
    unfold(lines, count, legs);
    return true;
}

}
