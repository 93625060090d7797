#include "boards/pico/panel/spi_bus.hpp"

#include "boards/pico/chip/dma.hpp"
#include "boards/pico/chip/register.hpp"
#include "boards/pico/chip/resets.hpp"
#include "boards/pico/panel/bus_rates.hpp"
#include "firmware/settings/rp2040_pins.hpp"

namespace kfast::pico {
namespace {

// A unit (PL022)
struct Unit {
    std::uint32_t base;

    constexpr Register control0() const { return Register{base + 0x00}; }
    constexpr Register control1() const { return Register{base + 0x04}; }
    constexpr Register data() const { return Register{base + 0x08}; }
    constexpr Register status() const { return Register{base + 0x0C}; }
    constexpr Register prescale() const { return Register{base + 0x10}; }
    constexpr Register dma_control() const { return Register{base + 0x24}; }
};

constexpr Unit unit_of(int number) { return {number == 0 ? 0x4003'C000u : 0x4004'0000u}; }

constexpr std::uint32_t frame_size = 0xF; // bits, less one
constexpr std::uint32_t clock_idles_high = 1 << 6;
constexpr std::uint32_t second_edge_counts = 1 << 7;
constexpr int divisor_at = 8;
constexpr std::uint32_t unit_enable = 1 << 1;
constexpr std::uint32_t dma_feeds = 1 << 1;
constexpr std::uint32_t room_to_send = 1 << 1;
constexpr std::uint32_t sending = 1 << 4;

// Controllers take bits at the rising edge, that is in mode 0 or 3. In mode 0 this unit ends every frame with
// a pulse on its frame line, for which the clock stands still; in mode 3 frame follows frame.
constexpr std::uint32_t mode_3 = clock_idles_high | second_edge_counts;

// Controllers need CS high for 40 ns; two accesses to pins alone would make 16.
void pause_40_ns() { asm volatile("nop\n nop\n nop\n nop\n nop"); }

void start(int unit, const SpiRate& rate)
{
    const Unit spi = unit_of(unit);
    resets::restart(unit == 0 ? resets::spi0 : resets::spi1);
    spi.prescale().write(rate.prescale);
    spi.control0().write((rate.divisor - 1) << divisor_at | mode_3 | (8 - 1));
    spi.dma_control().write(dma_feeds);
    spi.control1().write(unit_enable);
}

constexpr dma::Request request_of(int unit)
{
    return unit == 0 ? dma::Request::spi0_tx : dma::Request::spi1_tx;
}

}

SpiBus::SpiBus(const BoardSettings& settings)
    : unit_{*rp2040::spi_clock_unit(settings.pin(PinRole::clock))},
      select_{settings.pin(PinRole::select), Pad::fast_output}, dc_{settings.pin(PinRole::dc),
                                                                    Pad::fast_output}
{
    start(unit_, spi_rate(settings.bus_clock));
    dma::begin();
    connect(settings.pin(PinRole::clock), PinFunction::spi, Pad::fast_output);
    connect(settings.pin(PinRole::data), PinFunction::spi, Pad::fast_output);
}

void SpiBus::command(std::span<const std::byte> bytes)
{
    dc_.low();
    send(bytes);
}

void SpiBus::parameters(std::span<const std::byte> bytes)
{
    dc_.high();
    send(bytes);
}

void SpiBus::start_data(std::span<const std::byte> bytes)
{
    dc_.high();
    select(8);
    dma::start(bytes, dma::Piece::byte, unit_of(unit_).data(), request_of(unit_));
}

void SpiBus::start_words(std::span<const std::byte> words)
{
    dc_.high();
    select(16);
    dma::start(words, dma::Piece::word_16, unit_of(unit_).data(), request_of(unit_));
}

// The unit still sends when the last piece is in its FIFO. What it receives meanwhile overruns the other
// FIFO, which harms nothing.
bool SpiBus::busy() const { return dma::busy() || (unit_of(unit_).status().read() & sending) != 0; }

// The size of frames changes while nothing is sent, but without a halt of the unit: the clock line must not
// move where CS is wired low.
void SpiBus::select(std::uint32_t frame_bits) const
{
    select_.high();
    const Register control = unit_of(unit_).control0();
    control.write((control.read() & ~frame_size) | (frame_bits - 1));
    pause_40_ns();
    select_.low();
}

void SpiBus::send(std::span<const std::byte> bytes) const
{
    select(8);
    const Unit spi = unit_of(unit_);
    for (const std::byte byte : bytes) {
        while ((spi.status().read() & room_to_send) == 0) {
        }
        spi.data().write(std::to_integer<std::uint32_t>(byte));
    }
    while (busy()) {
    }
}

}
