#pragma once

#include "host/picture/timeline.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace kfast {

/// A picture of a film: what it shows, and from when to when, in ticks of the scene's clock since the film
/// began.
struct FilmMoment {
    Time time;
    std::int64_t begin = 0;
    std::int64_t end = 0;
};

/// When the picture with this number begins, from 0, which does at 0.
using FilmPace = std::function<std::int64_t(std::int64_t number)>;

constexpr std::int64_t every_frame(std::int64_t number) { return number * Time::ticks_per_frame; }

/// One period of what is played, for ping-pong there and back. What is played once ends with its very end,
/// which is shown for a frame.
std::vector<FilmMoment> film_moments(const Timeline& timeline, const FilmPace& pace = every_frame);

}
