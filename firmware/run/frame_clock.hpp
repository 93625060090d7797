#pragma once

#include "core/bytes/expects.hpp"
#include "firmware/chip/microseconds.hpp"

#include <cstdint>

namespace kfast {

/// When the frames of a scene are due: frame n at start + n / rate, rounded down, without drift.
class FrameClock {
public:
    /// `frame_rate` in frames per 1000 seconds, at least 1. Frame 0 is due at `start`.
    constexpr FrameClock(std::uint32_t frame_rate, Microseconds start)
        : rate_{frame_rate}, due_{start}, following_{start}
    {
        expects(frame_rate >= 1);
        step(following_);
    }

    constexpr Microseconds due() const { return due_.moment; }
    /// When the frame after that is due.
    constexpr Microseconds following() const { return following_.moment; }

    /// Moves on to the next frame, or past it to the last one that is due at `now`: late frames are left out.
    /// Returns how far it moved, in frames. A frame must not take longer than 35 minutes.
    constexpr std::uint32_t advance(Microseconds now)
    {
        std::uint32_t frames = 0;
        do {
            due_ = following_;
            step(following_);
            ++frames;
        } while (reached(now, following_.moment));
        return frames;
    }

private:
    struct Due {
        constexpr Due(Microseconds start) : moment{start} {}

        Microseconds moment;
        std::uint32_t rest = 0; ///< in 1/rate microseconds; carried along so that no error adds up
    };

    static constexpr std::uint32_t microseconds_per_1000_s = 1'000'000'000;

    constexpr void step(Due& due) const
    {
        const std::uint32_t part = microseconds_per_1000_s % rate_;
        const bool carry = due.rest >= rate_ - part;
        due.rest = carry ? due.rest - (rate_ - part) : due.rest + part;
        due.moment = due.moment + Microseconds{microseconds_per_1000_s / rate_ + (carry ? 1 : 0)};
    }

    std::uint32_t rate_;
    Due due_;
    Due following_;
};

}
