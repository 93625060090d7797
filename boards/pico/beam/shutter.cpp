#include "boards/pico/beam/shutter.hpp"

#include <optional>

namespace kfast::pico::shutter {
namespace {

// All of them begin with zero: start.cpp knows no other.
std::optional<Pin> pin;
bool is_handed_over = false;
bool is_armed_now = false;
bool is_busy_now = false;

void settle()
{
    const bool is_open = is_armed_now && is_busy_now;
    const PinFunction function = is_handed_over ? PinFunction::pio0 : PinFunction::sio;
    if (pin)
        gpio_ctrl(*pin).write(static_cast<std::uint32_t>(function) | (is_open ? 0 : gpio_ctrl_outover_high));
}

}

void begin(Pin blank)
{
    const OutputPin closed{blank, Pad::output};
    pin = blank;
    settle();
}

void hand_over()
{
    is_handed_over = true;
    settle();
}

void set_armed(bool is_armed)
{
    is_armed_now = is_armed;
    settle();
}

void set_busy(bool is_busy)
{
    is_busy_now = is_busy;
    settle();
}

void close_for_good()
{
    is_armed_now = false;
    settle();
}

}

/// What start.cpp does first when the processor has met an exception.
extern "C" void make_safe() { kfast::pico::shutter::close_for_good(); }
