#pragma once

#include "firmware/link/message.hpp"
#include "firmware/status.hpp"

namespace kfast::link {

/// Whether a dangerous beam may shine. It begins dark. What a computer has armed is disarmed as soon as that
/// computer is gone, as it cannot disarm it any more; what somebody at the board has armed remains theirs.
class LaserInterlock {
public:
    /// `set_armed` lets the beam shine, or not. Null: there is no dangerous beam.
    explicit LaserInterlock(void (*set_armed)(bool is_armed)) : set_armed_{set_armed} {}

    Arming state() const
    {
        if (set_armed_ == nullptr)
            return Arming::none;
        return is_armed_ ? Arming::armed : Arming::disarmed;
    }

    /// By a computer. Fails with no_laser.
    Status arm()
    {
        if (set_armed_ == nullptr)
            return Status::no_laser;
        if (is_armed_)
            return Status::ok;
        set(true);
        is_armed_by_computer_ = true;
        return Status::ok;
    }

    /// By a computer. Fails with no_laser.
    Status disarm()
    {
        if (set_armed_ == nullptr)
            return Status::no_laser;
        set(false);
        return Status::ok;
    }

    /// By somebody at the board.
    void toggle() { set(!is_armed_); }

    void lose_computer()
    {
        if (is_armed_by_computer_)
            set(false);
    }

private:
    void set(bool is_armed)
    {
        is_armed_by_computer_ = false;
        if (set_armed_ == nullptr || is_armed == is_armed_)
            return;
        is_armed_ = is_armed;
        set_armed_(is_armed);
    }

    void (*set_armed_)(bool);
    bool is_armed_ = false;
    bool is_armed_by_computer_ = false;
};

}
