#include "host/picture/film.hpp"

#include "core/time/time.hpp"

#include <algorithm>
#include <limits>

namespace kfast {

std::vector<FilmMoment> film_moments(const Timeline& timeline, const FilmPace& pace)
{
    std::vector<FilmMoment> moments;
    const std::int64_t period = timeline.period_ticks();
    std::int64_t begin = 0;
    for (std::int64_t next = 1; begin < period; ++next) {
        const std::int64_t end = std::min(pace(next), period);
        moments.push_back({timeline.shown_at(begin), begin, end});
        begin = end;
    }
    if (timeline.stretch.loop == Loop::once)
        moments.push_back({timeline.shown_at(period), period, period + Time::ticks_per_frame});
    return moments;
}

namespace {

constexpr std::int64_t max = std::numeric_limits<std::uint16_t>::max();

struct Ratio {
    std::int64_t numerator;
    std::int64_t denominator;
};

}

FilmDelay film_delay(std::int64_t ticks, std::uint32_t frame_rate)
{
    Ratio rest{ticks * 1000, std::int64_t{frame_rate} * Time::ticks_per_frame};
    if (rest.numerator / rest.denominator >= max)
        return {static_cast<std::uint16_t>(max), 1, false};
    Ratio before{1, 0};
    Ratio last{rest.numerator / rest.denominator, 1};
    rest = {rest.denominator, rest.numerator % rest.denominator};
    while (rest.denominator != 0) {
        const std::int64_t step = rest.numerator / rest.denominator;
        const Ratio next{step * last.numerator + before.numerator,
                         step * last.denominator + before.denominator};
        if (next.numerator > max || next.denominator > max)
            break;
        before = last;
        last = next;
        rest = {rest.denominator, rest.numerator % rest.denominator};
    }
    return {static_cast<std::uint16_t>(last.numerator), static_cast<std::uint16_t>(last.denominator),
            rest.denominator == 0};
}

namespace {

constexpr std::int64_t shortest_delay = 2;
constexpr std::int64_t longest_delay = 65535;
constexpr std::uint32_t highest_rate = 50000;

/// Rounds down, so that the time has begun.
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
