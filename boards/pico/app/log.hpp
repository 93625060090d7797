#pragma once

#include "firmware/serial/console.hpp"
#include "firmware/settings/board_settings.hpp"

namespace kfast::pico {

/// What the board prints to a serial terminal: lines at 115200 baud, 8 bits, no parity, sent while the
/// program goes on. A line is sent when its '\n' is written; one that does not fit in the buffer is lost.
class Log {
public:
    /// Needs start_clocks(). Nothing is printed if the pin cannot send.
    void begin(Pin pin) const;
    /// Whether anything is printed.
    bool is_on() const;

    void write(char letter) const;

    /// Waits until all lines have been sent; with interrupts off as well.
    void send_waiting() const;
};

/// There is one.
inline constexpr Log log;

}
