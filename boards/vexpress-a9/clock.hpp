#pragma once

#include "firmware/chip/microseconds.hpp"

namespace kfast::vexpress_a9 {

/// The time since begin(), kept by a timer that counts down at 1 MHz.
class Clock {
public:
    void begin();
    Microseconds now() const;
    /// Sleeps until a second timer has run out.
    void sleep_until(Microseconds moment) const;
};

}
