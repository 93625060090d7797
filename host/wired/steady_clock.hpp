#pragma once

#include "firmware/microseconds.hpp"

namespace kfast {

/// The clock of a computer, for a board that sleeps between pictures.
class SteadyClock {
public:
    Microseconds now() const;
    /// All of that time.
    void pause(Microseconds time) const;
    /// Until `moment`, or until a signal has come that RememberedInterruption remembers.
    void sleep_until(Microseconds moment) const;
};

}
