#include "host/picture/gif_moment.hpp"

#include "host/picture/film_moment.hpp"

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

GifMoment gif_moment(const Timeline& timeline, const FilmMoment& moment)
{
    const std::int64_t delay = centiseconds(timeline, moment.end) - centiseconds(timeline, moment.begin);
    return {moment.time, static_cast<int>(std::clamp(delay, shortest_delay, longest_delay))};
}

}

std::vector<GifMoment> gif_moments(const Timeline& timeline)
{
    const FilmPace not_too_fast = [&timeline](std::int64_t number) {
        return timeline.frame_rate > highest_rate ? ticks_at(timeline, number * shortest_delay)
                                                  : every_frame(number);
    };
    std::vector<GifMoment> moments;
    for (const FilmMoment& moment : film_moments(timeline, not_too_fast))
        moments.push_back(gif_moment(timeline, moment));
    return moments;
}

}
