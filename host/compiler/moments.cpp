#include "host/compiler/moments.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace kfast {
namespace {

constexpr std::int32_t most_frames = 200;
constexpr std::size_t most_keys = 100;
constexpr std::int32_t least_between_keys = 8;

/// `since`, `until`, and between them some of `key_times`, or all.
std::vector<Time> stops_between(Time since, Time until, const std::vector<Time>& key_times)
{
    std::vector<Time> inner;
    std::ranges::copy_if(key_times, std::back_inserter(inner),
                         [&](Time time) { return time > since && time < until; });
    std::vector<Time> stops{since};
    const std::size_t every = inner.size() / most_keys + 1;
    for (std::size_t i = 0; i < inner.size(); i += every)
        stops.push_back(inner[i]);
    stops.push_back(until);
    return stops;
}

}

std::vector<Time> moments_between(Time since, Time until, const std::vector<Time>& key_times)
{
    const std::int32_t step = std::max(Time::ticks_per_frame, (until - since).ticks / most_frames + 1);
    const std::vector<Time> stops = stops_between(since, until, key_times);
    std::vector<Time> moments;
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
        const std::int32_t ticks = (stops[i + 1] - stops[i]).ticks;
        const std::int32_t count = std::min(ticks, std::max(least_between_keys, ticks / step + 1));
        for (std::int32_t k = 0; k < count; ++k)
            moments.push_back(stops[i] + Time{static_cast<std::int32_t>(std::int64_t{ticks} * k / count)});
    }
    moments.push_back(until);
    return moments;
}

}
