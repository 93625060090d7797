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

    constexpr Register sspcr0() const { return Register{base + 0x00}; }
    constexpr Register sspcr1() const { return Register{base + 0x04}; }
    constexpr Register sspdr() const { return Register{base + 0x08}; }
    constexpr Register sspsr() const { return Register{base + 0x0C}; }
    constexpr Register sspcpsr() const { return Register{base + 0x10}; }
    constexpr Register sspdmacr() const { return Register{base + 0x24}; }
};

constexpr Unit unit_of(int number) { return {number == 0 ? 0x4003'C000u : 0x4004'0000u}; }

constexpr std::uint32_t sspcr0_dss = 0xF;    // bits, less one
constexpr std::uint32_t sspcr0_spo = 1 << 6; // the clock idles high
constexpr std::uint32_t sspcr0_sph = 1 << 7; // the second edge counts
constexpr int sspcr0_scr_lsb = 8;
constexpr std::uint32_t sspcr1_sse = 1 << 1;
constexpr std::uint32_t sspdmacr_txdmae = 1 << 1;
constexpr std::uint32_t sspsr_tnf = 1 << 1; // there is room in the FIFO
constexpr std::uint32_t sspsr_bsy = 1 << 4;

// Controllers take bits at the rising edge, that is in mode 0 or 3. In mode 0 this unit ends every frame with
// a pulse on its frame line, for which the clock stands still; in mode 3 frame follows frame.
constexpr std::uint32_t mode_3 = sspcr0_spo | sspcr0_sph;

// Controllers need CS high for 40 ns; two accesses to pins alone would make 16.
void pause_40_ns() { asm volatile("nop\n nop\n nop\n nop\n nop"); }

void start(int unit, const SpiRate& rate)
{
    const Unit spi = unit_of(unit);
    resets::restart(unit == 0 ? resets::spi0 : resets::spi1);
    spi.sspcpsr().write(rate.prescale);
    spi.sspcr0().write((rate.divisor - 1) << sspcr0_scr_lsb | mode_3 | (8 - 1));
    spi.sspdmacr().write(sspdmacr_txdmae);
    spi.sspcr1().write(sspcr1_sse);
}

constexpr dma::Dreq request_of(int unit) { return unit == 0 ? dma::Dreq::spi0_tx : dma::Dreq::spi1_tx; }

}

SpiBus::SpiBus(const BoardSettings& settings)
    : unit_{*rp2040::spi_clock_unit(settings.pin(PinRole::clock))},
      select_{settings.pin(PinRole::select), Pad::fast_output},
      dc_{settings.pin(PinRole::dc), Pad::fast_output}
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
    dma::start(bytes, dma::DataSize::byte, unit_of(unit_).sspdr(), request_of(unit_));
}

void SpiBus::start_words(std::span<const std::byte> words)
{
    dc_.high();
    select(16);
    dma::start(words, dma::DataSize::halfword, unit_of(unit_).sspdr(), request_of(unit_));
}

// The unit still sends when the last piece is in its FIFO. What it receives meanwhile overruns the other
// FIFO, which does no harm.
bool SpiBus::busy() const { return dma::busy() || (unit_of(unit_).sspsr().read() & sspsr_bsy) != 0; }

// The size of frames changes while nothing is sent, but without a halt of the unit: the clock line must not
// move where CS is wired low.
void SpiBus::select(std::uint32_t frame_bits) const
{
    select_.high();
    const Register control = unit_of(unit_).sspcr0();
    control.write((control.read() & ~sspcr0_dss) | (frame_bits - 1));
    pause_40_ns();
    select_.low();
}

void SpiBus::send(std::span<const std::byte> bytes) const
{
    select(8);
    const Unit spi = unit_of(unit_);
    for (const std::byte byte : bytes) {
        while ((spi.sspsr().read() & sspsr_tnf) == 0) {
        }
        spi.sspdr().write(std::to_integer<std::uint32_t>(byte));
    }
    while (busy()) {
    }
}

}
