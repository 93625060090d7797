#include "host/lottie/values/looped_time.hpp"

#include "host/lottie/values/ways.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace kfast::lottie {
namespace {

using Ways = std::vector<Way<double>>;

constexpr double same = 1e-6; ///< frames: a difference by computing alone

bool is_even(const Ways& ways)
{
    const Way<double>& first = ways.front();
    const double speed = (first.end - first.begin) / (first.to - first.from);
    return std::ranges::all_of(ways, [&](const Way<double>& way) {
        const double expected = first.begin + speed * (way.to - first.from);
        return way.ease.kind == art::EaseKind::linear && std::abs(way.end - expected) < same;
    });
}

/// Whether the periods of a scene, which are whole ticks, are not too far from these in the end.
bool keeps_pace(double period, const art::Span& seen)
{
    constexpr double finest = 1.0 / 64; // frames
    const double ticks = period * Time::ticks_per_frame;
    const double passes = (seen.to - seen.from) / period;
    return ticks >= 1 && std::abs(std::round(ticks) - ticks) * passes < finest * Time::ticks_per_frame;
}

}

std::optional<LoopedTime> looped_time(const Json& layer, const LayerTime& outer, const art::Span& seen,
                                      double frame_rate, art::Budget& budget)
{
    const Property frame = read_property(layer, "tm"); // counts seconds
    if (!frame.loop)
        return std::nullopt;
    const auto value_of = [&](const Json& value) { return component(value, 0, 0) * frame_rate; };
    budget.take_keys(frame.keys.size());
    Ways ways = read_ways<double>(frame.keys, 0, value_of);
    place_in_scene(ways, outer);
    if (ways.size() < 3)
        return std::nullopt;
    const bool is_out = frame.loop->is_out == (outer.stretch > 0);
    const Ways once = repeated_ways(ways, frame.loop->segments, is_out);
    LoopedTime time{.from = once.front().from,
                    .period = once.back().to - once.front().from,
                    .begin = once.front().begin,
                    .end = once.back().end,
                    .loop = frame.loop->turns_back ? Loop::ping_pong : Loop::repeat};
    const bool has_before = ways[1].from < time.from && seen.from < time.from - same;
    const bool repeats = is_out ? seen.to > once.back().to : seen.from < time.from;
    // One that begins with its end would show its beginning for a moment.
    const bool begins_with_end = time.end < time.begin && !frame.loop->turns_back;
    if (!repeats || begins_with_end || std::abs(time.end - time.begin) < same || !is_even(once) ||
        !keeps_pace(time.period, seen))
        return std::nullopt;
    if (is_out)
        return has_before ? std::nullopt : std::optional{time};
    const double both = 2 * time.period;
    time.from -= both * std::ceil((time.from - seen.from) / both);
    return seen.to > once.back().to + same ? std::nullopt : std::optional{time};
}

}
