#pragma once

#include "firmware/chip/microseconds.hpp"

namespace kfast::lm3s6965evb {

/// The time since begin(), kept by SysTick.
class Clock {
public:
    void begin();
    Microseconds now() const;
    /// Sleeps between the ticks of a millisecond and polls during the last one.
    void sleep_until(Microseconds moment) const;
};

}
