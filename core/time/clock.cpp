#include "core/time/clock.hpp"

#include <algorithm>

namespace kfast {

[[gnu::cold]] Time Clock::at(Time time) const
{
    const std::int64_t waited = std::max<std::int64_t>(std::int64_t{time.ticks} - delay.ticks, 0);
    const std::int64_t run = waited * speed >> 16;
    if (length == Time{})
        return {static_cast<std::int32_t>(std::min<std::int64_t>(run, end_of_time.ticks))};
    const std::int64_t place = speed < 0 ? length.ticks + run : run;
    if (loop == Loop::once)
        return {static_cast<std::int32_t>(std::clamp<std::int64_t>(place, 0, length.ticks))};
    const Time wrapped =
        wrap({static_cast<std::int32_t>(place % (2 * std::int64_t{length.ticks}))}, length, loop);
    return speed < 0 && loop == Loop::repeat && wrapped == Time{} ? length : wrapped;
}

}
