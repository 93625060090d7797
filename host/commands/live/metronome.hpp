#pragma once

#include "host/link/report_pipe.hpp"

#include <algorithm>
#include <chrono>
#include <optional>
#include <thread>

namespace kfast {

/// Says when it is time for the next one of things that are to come so many times a second.
class Metronome {
public:
    /// Without a rate it is always time.
    explicit Metronome(const std::optional<double>& rate)
        : step_{rate ? std::chrono::duration_cast<Driver::duration>(std::chrono::duration<double>{1 / *rate})
                     : Driver::duration{0}}
    {
    }

    /// Whether it is time, for which it waits so long; then the next one is awaited. What comes too late
    /// shifts the rest only when it is very late.
    bool is_due(Milliseconds patience)
    {
        const auto now = Driver::now();
        if (now < due_) {
            std::this_thread::sleep_until(std::min(due_, now + patience));
            return false;
        }
        constexpr std::chrono::seconds very_late{1};
        due_ = (now - due_ > very_late ? now : due_) + step_;
        return true;
    }

private:
    using Driver = std::chrono::steady_clock;

    Driver::duration step_;
    Driver::time_point due_ = Driver::now();
};

}
