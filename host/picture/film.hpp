#pragma once

#include "host/picture/timeline.hpp"
#include "host/program/failure.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace kfast {

/// The maximum size of an animation that is assembled in memory; browsers give up long before.
struct FilmLimit {
    std::size_t mebibytes = 1024;

    /// Throws Failure if one became larger. `what` is its kind: "GIF".
    void require(std::size_t bytes, const char* what) const
    {
        if (bytes > mebibytes << 20)
            throw Failure(std::string{"the "} + what + " would be larger than " + std::to_string(mebibytes) +
                          " MiB: play less with --clip, choose a smaller --scale or --size, or make an .mp4");
    }
};

/// A picture of a film: what it shows, and from when to when, in ticks of the scene's time since the film
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

/// How long an animated PNG shows a picture: a fraction of a second.
struct FilmDelay {
    std::uint16_t numerator = 0;
    std::uint16_t denominator = 1;
    bool is_exact = true;
};

/// The fraction for `ticks` ticks of a scene's time, at least one, with `frame_rate` frames in 1000 seconds,
/// at least 1. Where no fraction of two 16-bit numbers is exact, the last of the convergents of its continued
/// fraction that still is one; 65535 s where it is longer.
FilmDelay film_delay(std::int64_t ticks, std::uint32_t frame_rate);

/// A picture of a GIF: what it shows, and for how long.
struct GifMoment {
    Time time;
    int centiseconds = 0;
};

/// One period of what is played, frame by frame. The delays follow the scene's time without drift (30 fps:
/// 3, 3, 4). Browsers show delays of 1 as 10, so scenes above 50 fps are drawn 50 times a second.
std::vector<GifMoment> gif_moments(const Timeline& timeline);

}
