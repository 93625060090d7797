#include "host/picture/film_moment.hpp"

#include <algorithm>

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

}
