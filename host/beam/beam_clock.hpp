#pragma once

#include "core/time/time.hpp"

#include <cstdint>

namespace kfast {

/// The scene's time, counted in the points of a beam that has drawn since its beginning.
class BeamClock {
public:
    /// `frame_rate`: frames in 1000 seconds; `rate`: points in a second.
    BeamClock(std::uint32_t frame_rate, std::uint32_t rate)
        : ticks_{std::int64_t{frame_rate} * Time::ticks_per_frame}, points_{std::int64_t{rate} * 1000}
    {
    }

    /// Both round down.
    std::int64_t points_at(Time time) const { return floored(time.ticks * points_, ticks_); }
    Time time_at(std::int64_t points) const
    {
        return {static_cast<std::int32_t>(floored(points * ticks_, points_))};
    }

private:
    static constexpr std::int64_t floored(std::int64_t dividend, std::int64_t divisor)
    {
        return dividend / divisor - (dividend % divisor < 0 ? 1 : 0);
    }

    std::int64_t ticks_;  ///< of the scene
    std::int64_t points_; ///< in the same time
};

}
