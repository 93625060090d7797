#include "host/fit/lateness.hpp"

#include "firmware/run/frame_clock.hpp"
#include "host/fit/slack.hpp"

#include <algorithm>
#include <cmath>

namespace kfast::fit {
namespace {

/// Well below the 35 minutes of FrameClock.
constexpr double longest_frame = 1000;

Microseconds microseconds_of(double seconds)
{
    return {static_cast<std::uint32_t>(std::min(seconds / slack, longest_frame) * 1e6)};
}

}

Lateness lateness(std::span<const double> seconds, double frames_per_second)
{
    Lateness found{.frames = seconds.size()};
    const long rate = std::max(1L, std::lround(frames_per_second * 1000));
    FrameClock clock{static_cast<std::uint32_t>(rate), Microseconds{}};
    Microseconds now;
    for (std::size_t frame = 0; frame < seconds.size();) {
        now = now + microseconds_of(seconds[frame]);
        const bool is_late = reached(now, clock.following());
        const std::size_t moved = std::min<std::size_t>(clock.advance(now), seconds.size() - frame);
        found.left_out += moved - 1;
        found.late += moved - 1 + (is_late ? 1 : 0);
        frame += moved;
        if (!reached(now, clock.due()))
            now = clock.due();
    }
    return found;
}

std::string late_text(const Lateness& lateness)
{
    if (lateness.late == 0)
        return {};
    std::string text =
        std::to_string(lateness.late) + " of " + std::to_string(lateness.frames) + " pictures late";
    return lateness.left_out == 0 ? text
                                  : text + ", " + std::to_string(lateness.left_out) + " of them left out";
}

}
