#include "boards/lm3s6965evb/ssi.hpp"

#include "boards/lm3s6965evb/clocks.hpp"
#include "boards/lm3s6965evb/registers.hpp"

#include <atomic>
#include <cstdint>

namespace kfast::lm3s6965evb {
namespace {

// 50 MHz / (2 x 7): the controller takes a bit every 250 ns.
constexpr std::uint32_t prescale = 2;
constexpr std::uint32_t serial_rate = 6;
static_assert(system_hz / (prescale * (serial_rate + 1)) <= 4'000'000);

constexpr std::uint32_t room_to_send = 1 << 1;
constexpr std::uint32_t something_received = 1 << 2;
constexpr std::uint32_t sending = 1 << 4;
constexpr std::uint32_t half_empty_interrupt = 1 << 3;
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
    while ((ssi_sr.read() & something_received) != 0)
        static_cast<void>(ssi_dr.read());
}

void send(std::byte byte)
{
    while ((ssi_sr.read() & room_to_send) == 0) {
    }
    ssi_dr.write(std::to_integer<std::uint32_t>(byte));
    while ((ssi_sr.read() & sending) != 0) {
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
    ssi_cr1.write(0);
    ssi_cpsr.write(prescale);
    ssi_cr0.write(serial_rate << 8 | 0x07); // 8 bits, clock idles low, first edge counts
    ssi_cr1.write(2);
    nvic_enable.write(ssi0_interrupt);
}

void Ssi::command(std::span<const std::byte> bytes)
{
    gpio_c_pin7.write(command_level);
    for (const std::byte byte : bytes)
        send(byte);
}

void Ssi::parameters(std::span<const std::byte> bytes)
{
    gpio_c_pin7.write(data_level);
    for (const std::byte byte : bytes)
        send(byte);
}

void Ssi::start_data(std::span<const std::byte> bytes)
{
    gpio_c_pin7.write(data_level);
    std::atomic_signal_fence(
        std::memory_order_release); // the pixels are in memory before the interrupt looks
    next_pixel = bytes.data();
    last_pixel = bytes.data() + bytes.size();
    ssi_im.write(half_empty_interrupt);
}

bool Ssi::busy() const { return next_pixel != last_pixel || (ssi_sr.read() & sending) != 0; }

extern "C" void ssi0_handler()
{
    drop_received();
    for (int room = half_of_fifo; room > 0 && next_pixel != last_pixel; --room) {
        ssi_dr.write(std::to_integer<std::uint32_t>(*next_pixel));
        next_pixel = next_pixel + 1;
    }
    if (next_pixel == last_pixel)
        ssi_im.write(0);
}

}
