// A ball that bounces: prints its height frame by frame, from a few key times.
//
//     track

#include "core/time/track.hpp"

#include <array>
#include <cstdio>

using kfast::Time;

int main()
{
    std::array<kfast::KeySample, 8> memory;
    kfast::Track height{memory};
    height.add(Time::frame(0), 0);
    height.add(Time::frame(24), 0);
    height.add(Time::frame(12), 180); // in any order
    height.add(Time::frame(6), 135);
    height.add(Time::frame(18), 135);
    for (int frame = height.first_time().ticks / Time::ticks_per_frame; frame <= 24; ++frame) {
        const std::int32_t now = height.value_at(Time::frame(frame));
        std::printf("%2d %6.2f\n", frame, static_cast<double>(now) / (1 << kfast::fine_bits));
    }
}
