#pragma once

#include "firmware/chip/microseconds.hpp"

namespace kfast::pico {

/// The time since the chip's reset, kept by the timer. Needs start_clocks().
class Clock {
public:
    void begin();
    Microseconds now() const;
    /// Sleeps, and feeds the watchdog.
    void sleep_until(Microseconds moment) const;
    /// The same, but for at most a second, and only until any interrupt has come.
    void doze_until(Microseconds moment) const;
};

}
