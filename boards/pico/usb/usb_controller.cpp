#include "boards/pico/usb/usb_controller.hpp"

#include "boards/pico/chip/register.hpp"
#include "boards/pico/chip/resets.hpp"

#include <algorithm>
#include <atomic>

namespace kfast::pico {
namespace {

using usb::Endpoint;

constexpr Register addr_endp{0x5011'0000};
constexpr Register main_ctrl{0x5011'0040};
constexpr Register sie_ctrl{0x5011'004C};
constexpr Register sie_status{0x5011'0050};
constexpr Register buff_status{0x5011'0058};
constexpr Register ep_stall_arm{0x5011'0068};
constexpr Register usb_muxing{0x5011'0074};
constexpr Register usb_pwr{0x5011'0078};
constexpr Register inte{0x5011'0090};
constexpr Register ints{0x5011'0098};

constexpr std::uint32_t main_ctrl_controller_en = 1 << 0; // of a device: the host's bit is 0

constexpr std::uint32_t sie_ctrl_pullup_en = 1 << 16;
constexpr std::uint32_t sie_ctrl_ep0_int_1buf = 1 << 29; // also packets of endpoint 0 are in BUFF_STATUS

// In SIE_STATUS writing clears.
constexpr std::uint32_t sie_status_suspended = 1 << 4;
constexpr std::uint32_t sie_status_resume = 1 << 11;
constexpr std::uint32_t sie_status_setup_rec = 1 << 17;
constexpr std::uint32_t sie_status_bus_reset = 1 << 19;

constexpr std::uint32_t usb_muxing_to_phy = 1 << 0;
constexpr std::uint32_t usb_muxing_softcon = 1 << 3;

// No pin of the chip shows whether the plug has power: assume so, as all power comes from there.
constexpr std::uint32_t usb_pwr_vbus_detect = 1 << 2;
constexpr std::uint32_t usb_pwr_vbus_detect_override_en = 1 << 3;

// In INTE and INTS
constexpr std::uint32_t int_buff_status = 1 << 4;
constexpr std::uint32_t int_bus_reset = 1 << 12;
constexpr std::uint32_t int_dev_suspend = 1 << 14;
constexpr std::uint32_t int_dev_resume_from_host = 1 << 15;
constexpr std::uint32_t int_setup_req = 1 << 16;

/// The unit's memory (DPSRAM): by words or bytes, as one likes.
constexpr std::uint32_t dpram = 0x5010'0000;
constexpr std::uint32_t control_bytes = 0x100; // with all that is said about endpoints, and then the packets

// Of an endpoint's control word (EP1_IN_CONTROL and so on)
constexpr std::uint32_t ep_control_enable = 1U << 31;
constexpr std::uint32_t ep_control_interrupt_per_buff = 1 << 29;
constexpr std::uint32_t ep_control_endpoint_type_interrupt = 3 << 26;

// Of a packet's control word (EP0_IN_BUFFER_CONTROL and so on)
constexpr std::uint32_t buffer_control_full_0 = 1 << 15;
constexpr std::uint32_t buffer_control_pid_0 = 1 << 13; // DATA1
constexpr std::uint32_t buffer_control_stall = 1 << 11;
constexpr std::uint32_t buffer_control_available_0 = 1 << 10;
constexpr std::uint32_t buffer_control_length_0 = 0x3FF;

constexpr Register dpram_word(std::uint32_t offset) { return Register{dpram + offset}; }

constexpr Register ep_control(Endpoint endpoint) { return dpram_word(4 * place_of(endpoint)); }
constexpr Register ep_buffer_control(Endpoint endpoint) { return dpram_word(0x80 + 4 * place_of(endpoint)); }

constexpr bool is_control(Endpoint endpoint) { return usb::number_of(endpoint) == 0; }

/// Both control endpoints have the same.
constexpr std::uint32_t packet_offset(Endpoint endpoint)
{
    return is_control(endpoint) ? 0x100 : 0x180 + usb::packet_bytes * (place_of(endpoint) - 2);
}

std::byte* place_in_dpram(std::uint32_t offset) { return reinterpret_cast<std::byte*>(dpram + offset); }

/// At least a cycle of 48 MHz, so that the unit sees the rest of the word before what follows.
void let_unit_see()
{
    // Written out, because the compiler counts lines to know how far it can branch.
    asm volatile("nop\n nop\n nop\n nop\n nop\n nop\n" ::: "memory");
    asm volatile("nop\n nop\n nop\n nop\n nop\n nop\n" ::: "memory");
}

}

void UsbController::begin()
{
    resets::restart(resets::usbctrl);
    for (std::uint32_t offset = 0; offset < control_bytes; offset += 4)
        dpram_word(offset).write(0);
    usb_muxing.write(usb_muxing_to_phy | usb_muxing_softcon);
    usb_pwr.write(usb_pwr_vbus_detect | usb_pwr_vbus_detect_override_en);
    main_ctrl.write(main_ctrl_controller_en);
    sie_ctrl.write(sie_ctrl_ep0_int_1buf);
    inte.write(int_buff_status | int_bus_reset | int_dev_suspend | int_dev_resume_from_host | int_setup_req);
    enable(Interrupt::usbctrl_irq);
    sie_ctrl.set(sie_ctrl_pullup_en);
}

void UsbController::open(Endpoint endpoint)
{
    forget(endpoint, false);
    ep_control(endpoint).write(ep_control_enable | ep_control_interrupt_per_buff |
                               ep_control_endpoint_type_interrupt | packet_offset(endpoint));
}

void UsbController::close(Endpoint endpoint)
{
    ep_control(endpoint).write(0);
    forget(endpoint, false);
}

void UsbController::give(Endpoint endpoint, std::span<const std::byte> packet)
{
    take_back_broken_off(); // the program waits with interrupts off, and has copied the packet before
    std::copy_n(packet.data(), packet.size(), place_in_dpram(packet_offset(endpoint))); // by words
    std::atomic_signal_fence(std::memory_order_release); // all of it is there before it is handed over
    hand_over(endpoint, buffer_control_full_0 | static_cast<std::uint32_t>(packet.size()));
}

void UsbController::accept(Endpoint endpoint) { hand_over(endpoint, usb::packet_bytes); }

std::size_t UsbController::read(Endpoint endpoint, std::span<std::byte, usb::packet_bytes> place) const
{
    const std::size_t size =
        std::min<std::size_t>(ep_buffer_control(endpoint).read() & buffer_control_length_0, place.size());
    std::atomic_signal_fence(std::memory_order_acquire); // nothing is read before it is there
    std::copy_n(place_in_dpram(packet_offset(endpoint)), size, place.begin());
    return size;
}

void UsbController::stall(Endpoint endpoint)
{
    if (is_broken_off(endpoint))
        return;
    forget(endpoint, false);
    if (is_control(endpoint))
        ep_stall_arm.set(bit_of(endpoint)); // a setup clears it
    ep_buffer_control(endpoint).write(buffer_control_stall);
}

void UsbController::set_address(std::uint8_t address) { addr_endp.write(address); }

bool UsbController::take_bus_reset()
{
    if ((ints.read() & int_bus_reset) == 0)
        return false;
    sie_status.clear(sie_status_bus_reset | sie_status_suspended | sie_status_resume);
    addr_endp.write(0);
    for (const Endpoint endpoint : endpoints)
        forget(endpoint, false);
    return true;
}

bool UsbController::take_resume()
{
    const bool is_there = (ints.read() & int_dev_resume_from_host) != 0;
    if (is_there)
        sie_status.clear(sie_status_resume);
    return is_there;
}

bool UsbController::take_suspend()
{
    const bool is_there = (ints.read() & int_dev_suspend) != 0;
    if (is_there)
        sie_status.clear(sie_status_suspended);
    return is_there;
}

std::uint32_t UsbController::take_finished() const
{
    const std::uint32_t bits = buff_status.read();
    buff_status.clear(bits);
    return bits;
}

bool UsbController::read_setup(std::span<std::byte, usb::setup_bytes> packet)
{
    if ((sie_status.read() & sie_status_setup_rec) == 0)
        return false;
    sie_status.clear(sie_status_setup_rec); // before it is read: if one more comes meanwhile, it counts, too
    std::atomic_signal_fence(std::memory_order_acquire);
    std::copy_n(place_in_dpram(0), packet.size(), packet.begin());
    forget(Endpoint::control_in, true);
    forget(Endpoint::control_out, true);
    return true;
}

/// Whether a transfer is over that a stage of `endpoint` would belong to, because the computer has begun
/// another one. What it has broken off would be taken for the answer to that: an empty packet for a
/// descriptor, say.
bool UsbController::is_broken_off(Endpoint endpoint)
{
    return is_control(endpoint) && (sie_status.read() & sie_status_setup_rec) != 0;
}

/// Takes back what was handed over. Aborting it first is broken in early chips (erratum RP2040-E2) and not
/// needed: no computer asks for a packet of what it is about to set up.
void UsbController::forget(Endpoint endpoint, bool next_is_data_1)
{
    ep_buffer_control(endpoint).write(0);
    buff_status.clear(bit_of(endpoint));
    data_1_ = next_is_data_1 ? data_1_ | bit_of(endpoint) : data_1_ & ~bit_of(endpoint);
}

/// What was handed over for a transfer that is over, and has not been fetched. A computer that has set up the
/// next one asks for a packet at least 2.9 microseconds later, which is what its token of 35 bits takes.
void UsbController::take_back_broken_off()
{
    if (!is_broken_off(Endpoint::control_in))
        return;
    for (const Endpoint endpoint : {Endpoint::control_in, Endpoint::control_out})
        if ((ep_buffer_control(endpoint).read() & buffer_control_available_0) != 0)
            ep_buffer_control(endpoint).write(0); // of one that has ended the length is still to be read
}

void UsbController::hand_over(Endpoint endpoint, std::uint32_t what)
{
    if (is_broken_off(endpoint))
        return;
    const std::uint32_t word = what | ((data_1_ & bit_of(endpoint)) != 0 ? buffer_control_pid_0 : 0);
    data_1_ ^= bit_of(endpoint);
    ep_buffer_control(endpoint).write(word);
    let_unit_see();
    ep_buffer_control(endpoint).write(word | buffer_control_available_0);
    take_back_broken_off();
}

}
