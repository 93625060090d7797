#include "host/picture/gif_moment.hpp"

#include <algorithm>

namespace kfast {
namespace {

constexpr std::int64_t shortest_delay = 2;
constexpr std::int64_t longest_delay = 65535;
constexpr std::uint32_t highest_rate = 50000;

/// Rounds down, so that the moment has begun.
std::int64_t centiseconds(const Timeline& timeline, std::int64_t ticks)
{
    return ticks * 100'000 / (std::int64_t{timeline.frame_rate} * Time::ticks_per_frame);
}

/// Rounds up, so that centiseconds() gives the same again.
std::int64_t ticks_at(const Timeline& timeline, std::int64_t centiseconds)
{
    return (centiseconds * timeline.frame_rate * Time::ticks_per_frame + 99'999) / 100'000;
}

std::int64_t start_ticks(const Timeline& timeline, std::int64_t index)
{
    return timeline.frame_rate > highest_rate ? ticks_at(timeline, index * shortest_delay)
                                              : index * Time::ticks_per_frame;
}

GifMoment moment(const Timeline& timeline, std::int64_t start, std::int64_t end)
{
    const std::int64_t delay = centiseconds(timeline, end) - centiseconds(timeline, start);
    return {timeline.shown_at(start), static_cast<int>(std::clamp(delay, shortest_delay, longest_delay))};
}

}

std::vector<GifMoment> gif_moments(const Timeline& timeline)
{
    std::vector<GifMoment> moments;
    const std::int64_t period = timeline.period_ticks();
    std::int64_t start = 0;
    for (std::int64_t next = 1; start < period; ++next) {
        const std::int64_t end = std::min(start_ticks(timeline, next), period);
        moments.push_back(moment(timeline, start, end));
        start = end;
    }
    if (timeline.stretch.loop == Loop::once)
        moments.push_back(moment(timeline, period, period + Time::ticks_per_frame));
    return moments;
}

}
