#include "boards/pico/usb/usb_controller.hpp"

#include "boards/pico/chip/register.hpp"
#include "boards/pico/chip/resets.hpp"

#include <algorithm>
#include <atomic>

namespace kfast::pico {
namespace {

using usb::Endpoint;

constexpr Register device_address{0x5011'0000};
constexpr Register main_control{0x5011'0040};
constexpr Register line_control{0x5011'004C};  // SIE_CTRL
constexpr Register line_status{0x5011'0050};   // SIE_STATUS
constexpr Register finished{0x5011'0058};      // BUFF_STATUS
constexpr Register stall_control{0x5011'0068}; // EP_STALL_ARM
constexpr Register muxing{0x5011'0074};
constexpr Register power{0x5011'0078};
constexpr Register interrupt_enable{0x5011'0090};
constexpr Register interrupt_status{0x5011'0098};

constexpr std::uint32_t controller_enable = 1 << 0; // of a device: the host's bit is 0

// line_control
constexpr std::uint32_t pull_up = 1 << 16;
constexpr std::uint32_t ep0_int_1buf = 1 << 29; // EP0_INT_1BUF: in BUFF_STATUS

// line_status, where writing clears
constexpr std::uint32_t is_suspended = 1 << 4;
constexpr std::uint32_t is_resumed = 1 << 11;
constexpr std::uint32_t has_setup = 1 << 17;
constexpr std::uint32_t is_reset = 1 << 19;

constexpr std::uint32_t to_transceiver = 1 << 0;
constexpr std::uint32_t connected_by_software = 1 << 3;

// No pin of the chip tells whether the plug has power: believe so, as all power comes from there.
constexpr std::uint32_t plug_has_power = 1 << 2;
constexpr std::uint32_t override_power = 1 << 3;

constexpr std::uint32_t on_packet = 1 << 4;
constexpr std::uint32_t on_reset = 1 << 12;
constexpr std::uint32_t on_suspend = 1 << 14;
constexpr std::uint32_t on_resume = 1 << 15;
constexpr std::uint32_t on_setup = 1 << 16;

/// The unit's memory: by words or bytes, as one likes.
constexpr std::uint32_t memory = 0x5010'0000;
constexpr std::uint32_t control_bytes = 0x100; // with all that is said about endpoints, and then the packets

// Of an endpoint's control word
constexpr std::uint32_t endpoint_enable = 1U << 31;
constexpr std::uint32_t interrupt_per_buff = 1 << 29;
constexpr std::uint32_t of_interrupts = 3 << 26;

// Of a packet's control word
constexpr std::uint32_t packet_full = 1 << 15;
constexpr std::uint32_t packet_data_1 = 1 << 13;
constexpr std::uint32_t packet_stall = 1 << 11;
constexpr std::uint32_t packet_available = 1 << 10;
constexpr std::uint32_t packet_length = 0x3FF;

constexpr Register word_of_memory(std::uint32_t offset) { return Register{memory + offset}; }

constexpr Register endpoint_control(Endpoint endpoint) { return word_of_memory(4 * place_of(endpoint)); }
constexpr Register packet_control(Endpoint endpoint) { return word_of_memory(0x80 + 4 * place_of(endpoint)); }

constexpr bool is_control(Endpoint endpoint) { return usb::number_of(endpoint) == 0; }

/// Both control endpoints have the same.
constexpr std::uint32_t packet_offset(Endpoint endpoint)
{
    return is_control(endpoint) ? 0x100 : 0x180 + usb::packet_bytes * (place_of(endpoint) - 2);
}

std::byte* place_in_memory(std::uint32_t offset) { return reinterpret_cast<std::byte*>(memory + offset); }

/// A cycle of 48 MHz at the least, so that the unit sees the rest of the word before what follows.
void let_unit_see()
{
    // Written out, for the compiler counts lines to know how far it can branch.
    asm volatile("nop\n nop\n nop\n nop\n nop\n nop\n" ::: "memory");
    asm volatile("nop\n nop\n nop\n nop\n nop\n nop\n" ::: "memory");
}

}

void UsbController::begin()
{
    resets::restart(resets::usb);
    for (std::uint32_t offset = 0; offset < control_bytes; offset += 4)
        word_of_memory(offset).write(0);
    muxing.write(to_transceiver | connected_by_software);
    power.write(plug_has_power | override_power);
    main_control.write(controller_enable);
    line_control.write(ep0_int_1buf);
    interrupt_enable.write(on_packet | on_reset | on_suspend | on_resume | on_setup);
    enable(Interrupt::usb);
    line_control.set(pull_up);
}

void UsbController::open(Endpoint endpoint)
{
    forget(endpoint, false);
    endpoint_control(endpoint).write(endpoint_enable | interrupt_per_buff | of_interrupts |
                                     packet_offset(endpoint));
}

void UsbController::close(Endpoint endpoint)
{
    endpoint_control(endpoint).write(0);
    forget(endpoint, false);
}

void UsbController::give(Endpoint endpoint, std::span<const std::byte> packet)
{
    std::ranges::copy(packet, place_in_memory(packet_offset(endpoint)));
    std::atomic_signal_fence(std::memory_order_release); // all of it is there before it is handed over
    hand_over(endpoint, packet_full | static_cast<std::uint32_t>(packet.size()));
}

void UsbController::accept(Endpoint endpoint) { hand_over(endpoint, usb::packet_bytes); }

std::size_t UsbController::read(Endpoint endpoint, std::span<std::byte, usb::packet_bytes> place) const
{
    const std::size_t size =
        std::min<std::size_t>(packet_control(endpoint).read() & packet_length, place.size());
    std::atomic_signal_fence(std::memory_order_acquire); // nothing is read before it is there
    std::copy_n(place_in_memory(packet_offset(endpoint)), size, place.begin());
    return size;
}

void UsbController::stall(Endpoint endpoint)
{
    forget(endpoint, false);
    if (is_control(endpoint))
        stall_control.set(bit_of(endpoint)); // a setup clears it
    packet_control(endpoint).write(packet_stall);
}

void UsbController::set_address(std::uint8_t address) { device_address.write(address); }

UsbController::Event UsbController::next_line_event()
{
    const std::uint32_t events = interrupt_status.read();
    if ((events & on_reset) != 0) {
        line_status.clear(is_reset | is_suspended | is_resumed);
        device_address.write(0);
        for (const Endpoint endpoint : endpoints)
            forget(endpoint, false);
        return Event::bus_reset;
    }
    if ((events & on_suspend) != 0) {
        line_status.clear(is_suspended);
        return Event::suspended;
    }
    if ((events & on_resume) != 0) {
        line_status.clear(is_resumed);
        return Event::resumed;
    }
    return Event::none;
}

std::uint32_t UsbController::take_finished() const
{
    const std::uint32_t bits = finished.read();
    finished.clear(bits);
    return bits;
}

bool UsbController::read_setup(std::span<std::byte, usb::setup_bytes> packet)
{
    if ((line_status.read() & has_setup) == 0)
        return false;
    line_status.clear(has_setup); // before it is read: if one more comes meanwhile, it is told, too
    std::atomic_signal_fence(std::memory_order_acquire);
    std::copy_n(place_in_memory(0), packet.size(), packet.begin());
    forget(Endpoint::control_in, true);
    forget(Endpoint::control_out, true);
    return true;
}

/// Takes back what was handed over. Aborting it first is broken in early chips (erratum RP2040-E2) and not
/// needed: no computer asks for a packet of what it is about to set up.
void UsbController::forget(Endpoint endpoint, bool next_is_data_1)
{
    packet_control(endpoint).write(0);
    finished.clear(bit_of(endpoint));
    data_1_ = next_is_data_1 ? data_1_ | bit_of(endpoint) : data_1_ & ~bit_of(endpoint);
}

void UsbController::hand_over(Endpoint endpoint, std::uint32_t what)
{
    const std::uint32_t word = what | ((data_1_ & bit_of(endpoint)) != 0 ? packet_data_1 : 0);
    data_1_ ^= bit_of(endpoint);
    packet_control(endpoint).write(word);
    let_unit_see();
    packet_control(endpoint).write(word | packet_available);
}

}
