#include "boards/pico/log.hpp"

#include "boards/pico/clocks.hpp"
#include "boards/pico/interrupts.hpp"
#include "boards/pico/log_buffer.hpp"
#include "boards/pico/pins.hpp"
#include "boards/pico/register.hpp"
#include "boards/pico/resets.hpp"
#include "firmware/rp2040_pins.hpp"

namespace kfast::pico {
namespace {

// The divisor system_hz / (16 x baud) in 1/64, rounded: 4340, that is 67 + 52/64.
constexpr std::uint32_t baud = 115'200;
constexpr std::uint32_t divisor = (system_hz / 2 * 8 + baud / 2) / baud;
static_assert(divisor / 64 == 67 && divisor % 64 == 52);

constexpr std::uint32_t transmit_full = 1 << 5;
constexpr std::uint32_t busy = 1 << 3;
constexpr std::uint32_t room_interrupt = 1 << 5;

/// The registers of a UART (PL011).
class Uart {
public:
    constexpr Uart() = default;
    explicit constexpr Uart(int unit) : address_{unit == 0 ? 0x4003'4000U : 0x4003'8000U} {}

    constexpr bool is_there() const { return address_ != 0; }
    Register data() const { return Register{address_}; }
    Register flags() const { return Register{address_ + 0x18}; }
    Register whole_divisor() const { return Register{address_ + 0x24}; }
    Register rest_of_divisor() const { return Register{address_ + 0x28}; }
    Register line() const { return Register{address_ + 0x2C}; }
    Register control() const { return Register{address_ + 0x30}; }
    Register interrupts() const { return Register{address_ + 0x38}; }

private:
    std::uint32_t address_ = 0;
};

constinit Uart uart;
constinit LogBuffer buffer; // changes with interrupts off alone

void feed_uart()
{
    while (buffer.has_more() && (uart.flags().read() & transmit_full) == 0)
        uart.data().write(static_cast<std::uint8_t>(buffer.take()));
    uart.interrupts().write(buffer.has_more() ? room_interrupt : 0);
}

}

void Log::begin(Pin pin) const
{
    const auto unit = rp2040::uart_unit(pin);
    if (!unit)
        return;
    connect(pin, PinFunction::uart, Pad::output);
    resets::restart(*unit == 0 ? resets::uart0 : resets::uart1);
    uart = Uart{*unit};
    uart.whole_divisor().write(divisor / 64);
    uart.rest_of_divisor().write(divisor % 64);
    uart.line().write(0x70);     // 8 bits, FIFO on
    uart.control().write(0x101); // transmitter, on
    enable(*unit == 0 ? Interrupt::uart0 : Interrupt::uart1);
}

bool Log::is_on() const { return uart.is_there(); }

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
    while ((uart.flags().read() & busy) != 0) {
    }
}

extern "C" void uart_handler() { feed_uart(); }

}
