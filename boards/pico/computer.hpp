#pragma once

#include "boards/pico/clock.hpp"
#include "firmware/microseconds.hpp"

#include <cstdint>

namespace kfast::pico {

/// Whoever is at the other end of the USB cable. Nobody here understands reports yet: they are dropped and
/// counted.
class Computer {
public:
    /// Deals with the reports that have come. The computer has to wait if nobody does for 16 ms.
    void serve();
    /// Sleeps, and deals with reports as they come.
    void serve_until(Microseconds moment, const Clock& clock);

    std::uint32_t dropped() const { return dropped_; }

private:
    std::uint32_t dropped_ = 0;
};

}
