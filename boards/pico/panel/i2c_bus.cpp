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

    constexpr Register ic_con() const { return Register{base + 0x00}; }
    constexpr Register ic_tar() const { return Register{base + 0x04}; }
    constexpr Register ic_data_cmd() const { return Register{base + 0x10}; }
    constexpr Register ic_fs_scl_hcnt() const { return Register{base + 0x1C}; }
    constexpr Register ic_fs_scl_lcnt() const { return Register{base + 0x20}; }
    constexpr Register ic_intr_mask() const { return Register{base + 0x30}; }
    constexpr Register ic_raw_intr_stat() const { return Register{base + 0x34}; }
    constexpr Register ic_tx_tl() const { return Register{base + 0x3C}; }
    constexpr Register ic_clr_tx_abrt() const { return Register{base + 0x54}; } // by reading
    constexpr Register ic_enable() const { return Register{base + 0x6C}; }
    constexpr Register ic_status() const { return Register{base + 0x70}; }
    constexpr Register ic_sda_hold() const { return Register{base + 0x7C}; }
    constexpr Register ic_fs_spklen() const { return Register{base + 0xA0}; }
};

constexpr Unit unit_of(int number) { return {number == 0 ? 0x4004'4000u : 0x4004'8000u}; }

constexpr std::uint32_t ic_con_master_mode = 1 << 0;
constexpr std::uint32_t ic_con_speed_fast = 2 << 1;
constexpr std::uint32_t ic_con_ic_restart_en = 1 << 5;
constexpr std::uint32_t ic_con_ic_slave_disable = 1 << 6;
constexpr std::uint32_t ic_data_cmd_stop = 1 << 9; // after the byte
constexpr std::uint32_t intr_tx_empty = 1 << 4;    // in IC_INTR_MASK and IC_RAW_INTR_STAT
constexpr std::uint32_t intr_tx_abrt = 1 << 6;
constexpr std::uint32_t ic_status_tfnf = 1 << 1; // there is room in the FIFO
constexpr std::uint32_t ic_status_tfe = 1 << 2;  // the FIFO is empty
constexpr std::uint32_t ic_status_mst_activity = 1 << 5;

constexpr std::uint32_t refill_at = 4; // bytes left, 90 us at 400 kHz

// Pulses up to 56 ns are noise: I²C requires 50.
constexpr std::uint32_t spike_cycles = 7;
// 312 ns after SCL has fallen: the displays require 300.
constexpr std::uint32_t hold_cycles = 39;

constexpr std::uint32_t command_follows = 0x00;
constexpr std::uint32_t data_follows = 0x40;

// The transfer under way, shared with the interrupt.
int bus_unit = 0;
const std::byte* volatile next_byte = nullptr;
const std::byte* volatile last_byte = nullptr;
volatile bool was_aborted = false;

bool is_display_missing = false; // and the log has reported it

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
    i2c.ic_enable().write(0);
    i2c.ic_con().write(ic_con_master_mode | ic_con_speed_fast | ic_con_ic_restart_en |
                       ic_con_ic_slave_disable);
    i2c.ic_tar().write(settings.i2c_address);
    i2c.ic_fs_spklen().write(spike_cycles);
    i2c.ic_sda_hold().write(hold_cycles);
    i2c.ic_fs_scl_hcnt().write(rate.high - spike_cycles - 7); // the unit adds them by itself
    i2c.ic_fs_scl_lcnt().write(rate.low - 1);
    i2c.ic_tx_tl().write(refill_at);
    i2c.ic_intr_mask().write(0);
    i2c.ic_enable().write(1);
}

void fill(const Unit& i2c)
{
    const std::byte* next = next_byte;
    const std::byte* const last = last_byte;
    while (next != last && (i2c.ic_status().read() & ic_status_tfnf) != 0) {
        const auto byte = std::to_integer<std::uint32_t>(*next++);
        i2c.ic_data_cmd().write(byte | (next == last ? ic_data_cmd_stop : 0));
    }
    next_byte = next;
}

// The unit drops everything that is written to it from the moment of an abort until it is cleared.
void give_up(const Unit& i2c)
{
    next_byte = last_byte;
    was_aborted = true;
    static_cast<void>(i2c.ic_clr_tx_abrt().read());
}

void await_interrupt(const Unit& i2c)
{
    i2c.ic_intr_mask().write(next_byte == last_byte ? intr_tx_abrt : intr_tx_abrt | intr_tx_empty);
}

void serve()
{
    const Unit i2c = unit_of(bus_unit);
    if ((i2c.ic_raw_intr_stat().read() & intr_tx_abrt) != 0)
        give_up(i2c);
    else
        fill(i2c);
    await_interrupt(i2c);
}

// Not at once, in the interrupt, which may come within another line of the log.
void report_latest(const Unit& i2c)
{
    if (was_aborted && !is_display_missing)
        report::no_display(static_cast<std::uint8_t>(i2c.ic_tar().read()));
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
    i2c.ic_intr_mask().write(0);
    next_byte = bytes.data();
    last_byte = bytes.data() + bytes.size();
    i2c.ic_data_cmd().write(control_byte);
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
    enable(bus_unit == 0 ? Interrupt::i2c0_irq : Interrupt::i2c1_irq);
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
    const std::uint32_t status = unit_of(bus_unit).ic_status().read();
    return next_byte != last_byte || (status & ic_status_tfe) == 0 || (status & ic_status_mst_activity) != 0;
}

extern "C" void i2c0_handler() { serve(); }
extern "C" void i2c1_handler() { serve(); }

}
