#pragma once

#include "firmware/chip/microseconds.hpp"

#include <cstdint>

namespace kfast {

/// The clock of a computer, for a board that sleeps between pictures. When half an hour has passed since it
/// was asked last the program was stopped (Ctrl-Z), which does not count: the run loop could not tell that
/// from a frame that is not due yet.
class SteadyClock {
public:
    Microseconds now();
    /// All of that time.
    void pause(Microseconds time) const;
    /// Until `moment`, or until a signal has come that RememberedInterruption remembers.
    void sleep_until(Microseconds moment);

private:
    std::int64_t asked_ = 0;   ///< nanoseconds of the computer
    std::int64_t stopped_ = 0; ///< how many of them do not count
};

}
