#pragma once

#include "core/time/clock.hpp"
#include "core/time/time.hpp"

#include <span>

namespace kfast {

/// Where all clocks of a scene stand at once.
class Moment {
public:
    /// `inputs`, from 0 to whole_input each, must outlive the moment. One that is not told stands at 0.
    constexpr Moment(Time time = {}, std::span<const Time> inputs = {}) : time_{time}, inputs_{inputs} {}

    constexpr Time time() const { return time_; }
    constexpr Time at(Clock clock) const
    {
        if (clock.is_time())
            return time_;
        return clock.input <= inputs_.size() ? inputs_[clock.input - 1U] : Time{};
    }

private:
    Time time_;
    std::span<const Time> inputs_;
};

}
