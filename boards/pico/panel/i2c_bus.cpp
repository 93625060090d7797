#include "boards/pico/panel/i2c_bus.hpp"

#include "boards/pico/app/report.hpp"
#include "boards/pico/chip/clock.hpp"
#include "boards/pico/chip/interrupts.hpp"
#include "boards/pico/chip/pins.hpp"
#include "boards/pico/chip/register.hpp"
#include "boards/pico/chip/resets.hpp"
#include "boards/pico/panel/bus_rates.hpp"
#include "firmware/settings/rp2040_pins.hpp"

#include <atomic>
#include <cstdint>

namespace kfast::pico {
namespace {

// A unit (DW_apb_i2c)
struct Unit {
    std::uint32_t base;

    constexpr Register control() const { return Register{base + 0x00}; }
    constexpr Register target() const { return Register{base + 0x04}; }
    constexpr Register data() const { return Register{base + 0x10}; }
    constexpr Register high_count() const { return Register{base + 0x1C}; }
    constexpr Register low_count() const { return Register{base + 0x20}; }
    constexpr Register interrupt_mask() const { return Register{base + 0x30}; }
    constexpr Register raw_interrupts() const { return Register{base + 0x34}; }
    constexpr Register transmit_threshold() const { return Register{base + 0x3C}; }
    constexpr Register clear_abort() const { return Register{base + 0x54}; } // by reading
    constexpr Register enable() const { return Register{base + 0x6C}; }
    constexpr Register status() const { return Register{base + 0x70}; }
    constexpr Register data_hold() const { return Register{base + 0x7C}; }
    constexpr Register spike_length() const { return Register{base + 0xA0}; }
};

constexpr Unit unit_of(int number) { return {number == 0 ? 0x4004'4000u : 0x4004'8000u}; }

constexpr std::uint32_t master_in_fast_mode = 1 << 0 | 2 << 1;
constexpr std::uint32_t can_restart = 1 << 5;
constexpr std::uint32_t no_slave = 1 << 6;
constexpr std::uint32_t then_stop = 1 << 9;    // in `data`
constexpr std::uint32_t transmit_low = 1 << 4; // interrupts
constexpr std::uint32_t aborted = 1 << 6;
constexpr std::uint32_t room_to_send = 1 << 1; // in `status`
constexpr std::uint32_t transmit_empty = 1 << 2;
constexpr std::uint32_t sending = 1 << 5;

constexpr std::uint32_t refill_at = 4; // bytes left, 90 us at 400 kHz

// Pulses up to 56 ns are noise: I²C asks for 50.
constexpr std::uint32_t spike_cycles = 7;
// 312 ns after SCL has fallen: the displays ask for 300.
constexpr std::uint32_t hold_cycles = 39;

constexpr std::uint32_t command_follows = 0x00;
constexpr std::uint32_t data_follows = 0x40;

// The transfer under way, shared with the interrupt.
int bus_unit = 0;
const std::byte* volatile next_byte = nullptr;
const std::byte* volatile last_byte = nullptr;
volatile bool was_aborted = false;

bool is_display_missing = false; // and the log has told so

void wait_half_pulse()
{
    constexpr Microseconds half_pulse{6}; // at least 5: the slowest displays take 100 kHz
    const Clock clock;
    clock.sleep_until(clock.now() + half_pulse);
}

void pulse(const OpenDrainPin& clock)
{
    clock.pull_low();
    wait_half_pulse();
    clock.let_go();
    wait_half_pulse();
}

void stop(const OpenDrainPin& clock, const OpenDrainPin& data)
{
    clock.pull_low();
    data.pull_low();
    wait_half_pulse();
    clock.let_go();
    wait_half_pulse();
    data.let_go();
    wait_half_pulse();
}

// A reset of the chip does not reach a display without a reset pin. One that was about to acknowledge a byte
// holds SDA low until the clock goes on, and no unit starts on a bus that is not free.
void free_wires(Pin clock_pin, Pin data_pin)
{
    constexpr int bits_of_byte = 9;
    const OpenDrainPin clock{clock_pin};
    const OpenDrainPin data{data_pin};
    wait_half_pulse(); // wires that only the chip pulls up rise slowly
    for (int bit = 0; bit < bits_of_byte && !is_high(data_pin); ++bit)
        pulse(clock);
    stop(clock, data);
}

void configure(const Unit& i2c, const BoardSettings& settings)
{
    const I2cRate rate = i2c_rate(settings.bus_clock);
    i2c.enable().write(0);
    i2c.control().write(master_in_fast_mode | can_restart | no_slave);
    i2c.target().write(settings.i2c_address);
    i2c.spike_length().write(spike_cycles);
    i2c.data_hold().write(hold_cycles);
    i2c.high_count().write(rate.high - spike_cycles - 7); // the unit adds them by itself
    i2c.low_count().write(rate.low - 1);
    i2c.transmit_threshold().write(refill_at);
    i2c.interrupt_mask().write(0);
    i2c.enable().write(1);
}

void fill(const Unit& i2c)
{
    const std::byte* next = next_byte;
    const std::byte* const last = last_byte;
    while (next != last && (i2c.status().read() & room_to_send) != 0) {
        const auto byte = std::to_integer<std::uint32_t>(*next++);
        i2c.data().write(byte | (next == last ? then_stop : 0));
    }
    next_byte = next;
}

// The unit drops everything that is written to it from the moment of an abort until it is cleared.
void give_up(const Unit& i2c)
{
    next_byte = last_byte;
    was_aborted = true;
    static_cast<void>(i2c.clear_abort().read());
}

void await_interrupt(const Unit& i2c)
{
    i2c.interrupt_mask().write(next_byte == last_byte ? aborted : aborted | transmit_low);
}

void serve()
{
    const Unit i2c = unit_of(bus_unit);
    if ((i2c.raw_interrupts().read() & aborted) != 0)
        give_up(i2c);
    else
        fill(i2c);
    await_interrupt(i2c);
}

// Not at once, in the interrupt, which may come within another line of the log.
void report_latest(const Unit& i2c)
{
    if (was_aborted && !is_display_missing)
        report::no_display(static_cast<std::uint8_t>(i2c.target().read()));
    is_display_missing = was_aborted;
    was_aborted = false;
}

void start(std::uint32_t control_byte, std::span<const std::byte> bytes)
{
    if (bytes.empty())
        return;
    const Unit i2c = unit_of(bus_unit);
    report_latest(i2c);
    std::atomic_signal_fence(std::memory_order_release); // the bytes are in memory before the interrupt looks
    i2c.interrupt_mask().write(0);
    next_byte = bytes.data();
    last_byte = bytes.data() + bytes.size();
    i2c.data().write(control_byte);
    fill(i2c);
    await_interrupt(i2c);
}

}

I2cBus::I2cBus(const BoardSettings& settings)
{
    const Pin clock = settings.pin(PinRole::clock);
    const Pin data = settings.pin(PinRole::data);
    free_wires(clock, data);
    bus_unit = *rp2040::i2c_clock_unit(clock);
    resets::restart(bus_unit == 0 ? resets::i2c0 : resets::i2c1);
    connect(clock, PinFunction::i2c, Pad::pulled_up);
    connect(data, PinFunction::i2c, Pad::pulled_up);
    configure(unit_of(bus_unit), settings);
    enable(bus_unit == 0 ? Interrupt::i2c0 : Interrupt::i2c1);
}

void I2cBus::command(std::span<const std::byte> bytes)
{
    start(command_follows, bytes);
    while (busy()) {
    }
}

void I2cBus::parameters(std::span<const std::byte> bytes)
{
    start_data(bytes);
    while (busy()) {
    }
}

void I2cBus::start_data(std::span<const std::byte> bytes) { start(data_follows, bytes); }

bool I2cBus::busy() const
{
    const std::uint32_t status = unit_of(bus_unit).status().read();
    return next_byte != last_byte || (status & transmit_empty) == 0 || (status & sending) != 0;
}

extern "C" void i2c0_handler() { serve(); }
extern "C" void i2c1_handler() { serve(); }

}
