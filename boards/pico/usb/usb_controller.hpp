#pragma once

#include "boards/pico/chip/interrupts.hpp"
#include "firmware/usb/controller.hpp"
#include "firmware/usb/setup_packet.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast::pico {

/// The index of an endpoint in all tables of the unit, and in its registers.
constexpr std::uint32_t place_of(usb::Endpoint endpoint)
{
    return 2 * usb::number_of(endpoint) + (is_in(endpoint) ? 0 : 1);
}

constexpr std::uint32_t bit_of(usb::Endpoint endpoint) { return 1U << place_of(endpoint); }

/// The chip's unit for USB as a device with two endpoints of its own: firmware/usb/controller.hpp says what
/// it does. All of it begins as zeros.
class UsbController {
public:
    using EventsOff = InterruptsOff;

    /// Shows the computer that something is plugged in. Needs start_clocks(); from now on interrupts come, of
    /// which each is to dispatch_events().
    void begin();

    void open(usb::Endpoint endpoint);
    void close(usb::Endpoint endpoint);
    void give(usb::Endpoint endpoint, std::span<const std::byte> packet);
    void accept(usb::Endpoint endpoint);
    std::size_t read(usb::Endpoint endpoint, std::span<std::byte, usb::packet_bytes> place) const;
    void stall(usb::Endpoint endpoint);
    void set_address(std::uint8_t address);

    /// Reports to a HidDevice what has happened. What ended before a transfer begins is reported before it;
    /// what the device hands over then for the transfer before goes nowhere.
    template <class Device>
    void dispatch_events(Device& device)
    {
        take_back_broken_off();
        if (take_bus_reset())
            device.bus_reset();
        dispatch_finished(device); // before the computer fell asleep
        dispatch_sleep(device);
        std::array<std::byte, usb::setup_bytes> packet;
        if (read_setup(packet))
            device.setup(packet);
    }

private:
    /// Which of both came last is not known when they are found together, as after flash has been erased:
    /// asleep is what makes a laser dark, and the next packet shows that the computer is awake.
    template <class Device>
    static void dispatch_sleep(Device& device)
    {
        if (take_resume())
            device.resumed();
        if (take_suspend())
            device.suspended();
    }

    template <class Device>
    void dispatch_finished(Device& device) const
    {
        const std::uint32_t finished = take_finished();
        for (const usb::Endpoint endpoint : endpoints) {
            if ((finished & bit_of(endpoint)) == 0)
                continue;
            take_back_broken_off(); // in time, whatever there is to be done
            if (is_in(endpoint))
                device.sent(endpoint);
            else
                device.received(endpoint);
        }
    }

    static constexpr std::array<usb::Endpoint, 4> endpoints{
        usb::Endpoint::control_in, usb::Endpoint::control_out, usb::Endpoint::reports_in,
        usb::Endpoint::reports_out};

    bool take_bus_reset();
    static bool take_resume();
    static bool take_suspend();
    std::uint32_t take_finished() const;
    bool read_setup(std::span<std::byte, usb::setup_bytes> packet);

    static bool is_broken_off(usb::Endpoint endpoint);
    static void take_back_broken_off();
    void forget(usb::Endpoint endpoint, bool next_is_data_1);
    void hand_over(usb::Endpoint endpoint, std::uint32_t what);

    std::uint32_t data_1_ = 0; ///< a bit for each endpoint whose next packet is DATA1, as in BUFF_STATUS
};

}
