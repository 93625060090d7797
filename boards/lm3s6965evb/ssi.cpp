#include "boards/lm3s6965evb/ssi.hpp"

#include "boards/lm3s6965evb/clocks.hpp"
#include "boards/lm3s6965evb/registers.hpp"
#include "firmware/chip/cortex_m.hpp"

#include <atomic>
#include <cstdint>

namespace kfast::lm3s6965evb {
namespace {

// 50 MHz / (2 x 7): the controller takes a bit every 250 ns.
constexpr std::uint32_t prescale = 2;
constexpr std::uint32_t serial_rate = 6;
static_assert(system_hz / (prescale * (serial_rate + 1)) <= 4'000'000);

constexpr int ssicr0_scr_lsb = 8;
constexpr std::uint32_t ssicr0_dss_8_bits = 7;
constexpr std::uint32_t ssicr1_sse = 1 << 1;
constexpr std::uint32_t ssisr_tnf = 1 << 1; // there is room in the FIFO
constexpr std::uint32_t ssisr_rne = 1 << 2; // something was received
constexpr std::uint32_t ssisr_bsy = 1 << 4;
constexpr std::uint32_t ssiim_txim = 1 << 3; // half of the FIFO is empty
constexpr int half_of_fifo = 4;
constexpr std::uint32_t ssi0_interrupt = 1 << 7;

constexpr std::uint32_t command_level = 0;
constexpr std::uint32_t data_level = 0x80;

// The pixels still to be sent, shared with the interrupt.
const std::byte* volatile next_pixel = nullptr;
const std::byte* volatile last_pixel = nullptr;

// Nothing comes back from a display, but a full receive FIFO would stop the emulated transmitter.
void drop_received()
{
    while ((ssisr.read() & ssisr_rne) != 0)
        static_cast<void>(ssidr.read());
}

void send(std::byte byte)
{
    while ((ssisr.read() & ssisr_tnf) == 0) {
    }
    ssidr.write(std::to_integer<std::uint32_t>(byte));
    while ((ssisr.read() & ssisr_bsy) != 0) {
    }
    drop_received();
}

}

void Ssi::begin()
{
    gpio_a_afsel.set(0x2C); // clock, frame, transmit
    gpio_a_den.set(0x2C);
    gpio_c_dir.set(0x80);
    gpio_c_den.set(0x80);
    ssicr1.write(0);
    ssicpsr.write(prescale);
    ssicr0.write(serial_rate << ssicr0_scr_lsb | ssicr0_dss_8_bits); // clock idles low, first edge counts
    ssicr1.write(ssicr1_sse);
    cortex_m::nvic_iser0.write(ssi0_interrupt);
}

void Ssi::command(std::span<const std::byte> bytes)
{
    gpio_c_data_pin7.write(command_level);
    for (const std::byte byte : bytes)
        send(byte);
}

void Ssi::parameters(std::span<const std::byte> bytes)
{
    gpio_c_data_pin7.write(data_level);
    for (const std::byte byte : bytes)
        send(byte);
}

void Ssi::start_data(std::span<const std::byte> bytes)
{
    gpio_c_data_pin7.write(data_level);
    std::atomic_signal_fence(
        std::memory_order_release); // the pixels are in memory before the interrupt looks
    next_pixel = bytes.data();
    last_pixel = bytes.data() + bytes.size();
    ssiim.write(ssiim_txim);
}

bool Ssi::busy() const { return next_pixel != last_pixel || (ssisr.read() & ssisr_bsy) != 0; }

extern "C" void ssi0_handler()
{
    drop_received();
    for (int room = half_of_fifo; room > 0 && next_pixel != last_pixel; --room) {
        ssidr.write(std::to_integer<std::uint32_t>(*next_pixel));
        next_pixel = next_pixel + 1;
    }
    if (next_pixel == last_pixel)
        ssiim.write(0);
}

}
