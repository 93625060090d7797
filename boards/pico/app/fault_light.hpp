#pragma once

#include "boards/pico/chip/led.hpp"
#include "firmware/chip/microseconds.hpp"

namespace kfast::pico {

/// The light on the board when there is nothing to show: half a second on, half a second off.
class FaultLight {
public:
    static constexpr Microseconds half_a_second{500'000};

    void begin(Microseconds now) { turns_ = now + half_a_second; }
    /// To be called often, after begin().
    void pass(Microseconds now)
    {
        if (!reached(now, turns_))
            return;
        turn();
        turns_ = turns_ + half_a_second;
    }
    /// Dark.
    void end()
    {
        if (is_lit_)
            turn();
    }

private:
    void turn()
    {
        led::toggle();
        is_lit_ = !is_lit_;
    }

    Microseconds turns_{};
    bool is_lit_ = false;
};

}
