#pragma once

#include "firmware/chip/microseconds.hpp"

#include <chrono>

namespace kfast {

/// A clock that stands still until somebody lets time pass.
class SimulatedClock {
public:
    Microseconds now() const { return {static_cast<std::uint32_t>(elapsed_.count())}; }
    /// Since the power came on; does not wrap.
    std::chrono::nanoseconds elapsed() const { return elapsed_; }

    void pass(Microseconds time) { elapsed_ += std::chrono::microseconds{time.count}; }

private:
    std::chrono::microseconds elapsed_{};
};

}
