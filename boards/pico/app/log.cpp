#include "boards/pico/app/log.hpp"

#include "boards/pico/app/log_buffer.hpp"
#include "boards/pico/chip/clocks.hpp"
#include "boards/pico/chip/interrupts.hpp"
#include "boards/pico/chip/pins.hpp"
#include "boards/pico/chip/resets.hpp"
#include "firmware/serial/pl011.hpp"
#include "firmware/settings/rp2040_pins.hpp"

#include <cstdint>
#include <optional>

namespace kfast::pico {
namespace {

constexpr std::uint32_t divisor = Pl011::divisor(system_hz, 115'200);
static_assert(divisor == 67 * 64 + 52);

constexpr Pl011 uart_of(int unit) { return Pl011{unit == 0 ? 0x4003'4000u : 0x4003'8000u}; }

constinit std::optional<Pl011> uart; // nothing: the log is off
constinit LogBuffer buffer;          // changes only with interrupts off

void feed_uart()
{
    while (buffer.has_more() && uart->can_transmit())
        uart->write(buffer.take());
    uart->interrupt_for_room(buffer.has_more());
}

}

void Log::begin(Pin pin) const
{
    const auto unit = rp2040::uart_unit(pin);
    if (!unit)
        return;
    connect(pin, PinFunction::uart, Pad::output);
    resets::restart(*unit == 0 ? resets::uart0 : resets::uart1);
    uart = uart_of(*unit);
    uart->begin(divisor);
    enable(*unit == 0 ? Interrupt::uart0_irq : Interrupt::uart1_irq);
}

bool Log::is_on() const { return uart.has_value(); }

void Log::write(char letter) const
{
    if (!is_on())
        return;
    const InterruptsOff guard;
    buffer.write(letter);
    if (letter == '\n')
        feed_uart();
}

void Log::send_waiting() const
{
    if (!is_on())
        return;
    const InterruptsOff guard;
    while (buffer.has_more())
        feed_uart();
    while (uart->is_sending()) {
    }
}

extern "C" void uart_handler() { feed_uart(); }

}
