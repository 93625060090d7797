#pragma once

#include "host/art/animation/ease.hpp"
#include "host/art/budget.hpp"
#include "host/lottie/values/channel.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace kfast::lottie {

/// How the transitions of a property are repeated outside of its keys.
struct PropertyLoop {
    bool is_out = true; ///< after the last key; else before the first
    bool turns_back = false;
    std::size_t segments = 0; ///< how many transitions, from that end; 0: all
};

/// The loop of a property whose expression is nothing else: loopOut("cycle"), loopIn("pingpong", 2).
std::optional<PropertyLoop> read_loop(const Json& property);

/// The transitions (Way) that are repeated, of all between the first key and the last.
template <typename Way>
std::vector<Way> repeated_ways(const std::vector<Way>& ways, std::size_t segments, bool is_out)
{
    std::vector<Way> between{ways.begin() + 1, ways.end() - 1};
    if (segments == 0 || segments >= between.size())
        return between;
    const auto count = static_cast<std::ptrdiff_t>(segments);
    return is_out ? std::vector<Way>{between.end() - count, between.end()}
                  : std::vector<Way>{between.begin(), between.begin() + count};
}

/// From their end to their beginning, in the same time.
template <typename Way>
std::vector<Way> reversed_ways(const std::vector<Way>& ways)
{
    const double both_ends = ways.front().from + ways.back().to;
    std::vector<Way> reversed;
    for (auto way = ways.rbegin(); way != ways.rend(); ++way)
        reversed.push_back(
            {both_ends - way->to, both_ends - way->from, way->end, way->begin, art::reversed(way->ease)});
    return reversed;
}

/// Repeats transitions, which have been placed in the scene, until the ends of what is seen.
///
///     keys                0--1--2
///     loopOut("cycle")    0--1--2--1--2--    what was endless gives way to the copies
template <typename Way>
void repeat_ways(std::vector<Way>& ways, const PropertyLoop& loop, const LayerTime& time, art::Budget& budget)
{
    if (ways.size() < 3)
        return;
    const bool is_out = loop.is_out == (time.stretch > 0);
    const std::vector<Way> once = repeated_ways(ways, loop.segments, is_out);
    const std::vector<Way> back = loop.turns_back ? reversed_ways(once) : once;
    const double period = once.back().to - once.front().from;
    const double gap = is_out ? time.seen.to - once.back().to : once.front().from - time.seen.from;
    if (!std::isfinite(gap))
        return;
    std::vector<Way> copies;
    for (double number = 1; (number - 1) * period < gap; ++number) {
        budget.take_keys(once.size());
        const double shift = is_out ? number * period : -number * period;
        for (Way way : std::fmod(number, 2) == 1 ? back : once) {
            way.from += shift;
            way.to += shift;
            copies.push_back(std::move(way));
        }
    }
    std::ranges::stable_sort(copies, {}, &Way::from);
    ways.insert(is_out ? ways.end() - 1 : ways.begin() + 1, copies.begin(), copies.end());
    Way& first = ways.front();
    first.to = ways[1].from;
    first.begin = first.end = ways[1].begin;
    Way& last = ways.back();
    last.from = ways[ways.size() - 2].to;
    last.begin = last.end = ways[ways.size() - 2].end;
}

}
