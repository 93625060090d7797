#pragma once

#include "firmware/report.hpp"
#include "firmware/usb/control_pipe.hpp"
#include "firmware/usb/controller.hpp"
#include "firmware/usb/descriptors.hpp"
#include "firmware/usb/report_pipes.hpp"
#include "firmware/usb/setup_packet.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace kfast::usb {

/// Names of at most 31 letters of ASCII each. The computer shows them to its user.
struct DeviceNames {
    std::string_view maker;
    std::string_view product;
    std::string_view serial; ///< no other device of this product has the same
};

/// A device of the class HID that carries reports in both directions and gives them no meaning: an operating
/// system needs no driver for it. All of it begins as zeros.
///
/// The program may call the first functions here at any time; the rest is for the controller, usually from
/// its interrupt.
template <UsbController C>
class HidDevice {
public:
    /// How many reports wait for take(), and how many for the computer.
    static constexpr std::size_t room_from_computer = 16;
    static constexpr std::size_t room_to_computer = 4;

    C& controller() { return controller_; }

    /// Must be called before the controller calls anything. What `names` refers to must outlive the device.
    void begin(const DeviceNames& names) { names_ = names; }

    /// The oldest report that the computer sent and nobody has taken. A shorter one is filled up with zeros.
    /// The computer waits as long as room_from_computer of them are left here.
    std::optional<Report> take()
    {
        Report report;
        return take_into(report) ? std::optional{report} : std::nullopt;
    }

    /// Returns false, and sends nothing, if no computer listens or room_to_computer reports wait already.
    bool send(const Report& report)
    {
        const typename C::EventsOff guard;
        return to_computer_.send(controller_, report);
    }

    /// Whether a computer has set the device up, and is awake.
    bool is_connected() const { return is_configured_ && !is_suspended_; }

    /// Changes when a computer begins anew. What was on its way before is lost, in both directions.
    std::uint32_t connections() const { return connections_; }

    void bus_reset()
    {
        new_address_.reset();
        is_suspended_ = false;
        disconnect();
    }

    // Whatever the computer sends or fetches shows that it is awake.

    void setup(std::span<const std::byte, setup_bytes> bytes)
    {
        is_suspended_ = false;
        new_address_.reset();
        if (!begin_transfer(SetupPacket::parse(bytes)))
            control_.refuse(controller_);
    }

    void sent(Endpoint endpoint)
    {
        is_suspended_ = false;
        if (endpoint == Endpoint::reports_in)
            to_computer_.sent(controller_);
        else if (control_.sent(controller_) && new_address_)
            controller_.set_address(*new_address_);
    }

    void received(Endpoint endpoint)
    {
        is_suspended_ = false;
        if (endpoint == Endpoint::reports_out)
            from_computer_.received(controller_);
        else if (control_.received())
            end_set_report();
    }

    void suspended() { is_suspended_ = true; }
    void resumed() { is_suspended_ = false; }

private:
    /// Notified of nothing for as long as a copy takes: UsbController::take_back_broken_off() has little
    /// time.
    bool take_into(Report& report)
    {
        const typename C::EventsOff guard;
        return from_computer_.take(controller_, report);
    }

    /// Returns false if it is refused.
    bool begin_transfer(const SetupPacket& packet)
    {
        switch (packet.kind) {
        case request::get_descriptor:
        case request::get_interface_descriptor:
            return answer_descriptor(packet);
        case request::get_device_status:
            return answer_word(packet, 0); // needs the cable's power, wakes nobody
        case request::get_interface_status:
            return is_our_interface(packet) && answer_word(packet, 0);
        case request::get_endpoint_status:
            return answer_endpoint_status(packet);
        case request::get_configuration:
            return answer_byte(packet, is_configured_ ? configuration_value : 0);
        case request::get_interface:
            return is_our_interface(packet) && answer_byte(packet, 0);
        case request::get_idle:
            return is_our_report(packet) && answer_byte(packet, idle_);
        case request::get_report:
            return answer_report(packet);
        case request::set_report:
            return begin_set_report(packet);
        default:
            return packet.length == 0 && obey(packet) && acknowledge();
        }
    }

    /// Executes a request without data; returns false if it is refused.
    bool obey(const SetupPacket& packet)
    {
        switch (packet.kind) {
        case request::set_address:
            return set_address(packet.value);
        case request::set_configuration:
            return set_configuration(packet.value);
        case request::set_interface:
            return is_our_interface(packet) && set_interface(packet.value);
        case request::set_endpoint_feature:
            return set_halt(packet, true);
        case request::clear_endpoint_feature:
            return set_halt(packet, false);
        case request::set_idle:
            return is_our_report(packet) && set_idle(packet.value_high());
        default:
            return false;
        }
    }

    bool acknowledge()
    {
        control_.acknowledge(controller_);
        return true;
    }

    bool answer(const SetupPacket& packet, std::span<const std::byte> data)
    {
        control_.answer(controller_, data, packet.length);
        return true;
    }

    bool answer_if(bool is_right, const SetupPacket& packet, std::span<const std::byte> data)
    {
        if (is_right)
            answer(packet, data);
        return is_right;
    }

    bool answer_byte(const SetupPacket& packet, std::uint8_t value)
    {
        answer_[0] = std::byte{value};
        return answer(packet, std::span{answer_}.first(1));
    }

    bool answer_word(const SetupPacket& packet, std::uint8_t value)
    {
        answer_[0] = std::byte{value};
        answer_[1] = std::byte{0};
        return answer(packet, std::span{answer_}.first(2));
    }

    bool answer_descriptor(const SetupPacket& packet)
    {
        const bool is_of_device = packet.kind == request::get_descriptor;
        const auto type = static_cast<DescriptorType>(packet.value_high());
        if (type == DescriptorType::string)
            return is_of_device && answer_string(packet, static_cast<StringIndex>(packet.value_low()));
        if (packet.value_low() != 0 || (!is_of_device && packet.index != 0))
            return false;
        switch (type) {
        case DescriptorType::device:
            return answer_if(is_of_device, packet, device_descriptor);
        case DescriptorType::configuration:
            return answer_if(is_of_device, packet, configuration_descriptor);
        case DescriptorType::hid:
            return answer_if(!is_of_device, packet, hid_descriptor());
        case DescriptorType::report:
            return answer_if(!is_of_device, packet, report_descriptor);
        default:
            return false;
        }
    }

    bool answer_string(const SetupPacket& packet, StringIndex index)
    {
        switch (index) {
        case StringIndex::languages:
            return answer(packet, languages_descriptor);
        case StringIndex::maker:
            return answer_text(packet, names_.maker);
        case StringIndex::product:
            return answer_text(packet, names_.product);
        case StringIndex::serial:
            return answer_text(packet, names_.serial);
        }
        return false;
    }

    bool answer_text(const SetupPacket& packet, std::string_view text)
    {
        const std::size_t size = write_string_descriptor(text, answer_);
        return answer(packet, std::span{answer_}.first(size));
    }

    bool answer_endpoint_status(const SetupPacket& packet)
    {
        if (packet.index == index_of(Endpoint::control_out) || packet.index == index_of(Endpoint::control_in))
            return answer_word(packet, 0);
        if (!is_configured_)
            return false;
        if (packet.index == index_of(Endpoint::reports_out))
            return answer_word(packet, from_computer_.is_halted() ? 1 : 0);
        return packet.index == index_of(Endpoint::reports_in) &&
               answer_word(packet, to_computer_.is_halted() ? 1 : 0);
    }

    bool answer_report(const SetupPacket& packet)
    {
        constexpr std::uint8_t input_report = 1;
        if (!is_our_report(packet) || packet.value_high() != input_report)
            return false;
        static_assert(report_bytes <= string_descriptor_bytes);
        std::ranges::copy(to_computer_.latest().bytes, answer_.begin());
        return answer(packet, std::span{answer_}.first(report_bytes));
    }

    bool begin_set_report(const SetupPacket& packet)
    {
        constexpr std::uint8_t output_report = 2;
        if (!is_our_report(packet) || packet.value_high() != output_report)
            return false;
        if (packet.length == 0 || packet.length > report_bytes)
            return false;
        control_.expect(controller_);
        return true;
    }

    void end_set_report()
    {
        if (from_computer_.put(controller_, Endpoint::control_out))
            control_.acknowledge(controller_);
        else
            control_.refuse(controller_);
    }

    bool set_address(std::uint16_t address)
    {
        constexpr std::uint16_t highest = 127;
        if (address > highest || is_configured_)
            return false;
        new_address_ = static_cast<std::uint8_t>(address); // the transfer ends at the old one
        return true;
    }

    bool set_configuration(std::uint16_t value)
    {
        if (value > configuration_value)
            return false;
        disconnect();
        if (value == configuration_value) {
            is_configured_ = true;
            connections_ = connections_ + 1;
            open_pipes();
        }
        return true;
    }

    /// There is only one setting; choosing it begins both pipes anew, too.
    bool set_interface(std::uint16_t setting)
    {
        if (setting != 0)
            return false;
        open_pipes();
        return true;
    }

    bool set_halt(const SetupPacket& packet, bool is_halted)
    {
        constexpr std::uint16_t endpoint_halt = 0;
        if (packet.value != endpoint_halt || !is_configured_)
            return false;
        if (packet.index == index_of(Endpoint::reports_out))
            return set_halt(from_computer_, is_halted);
        return packet.index == index_of(Endpoint::reports_in) && set_halt(to_computer_, is_halted);
    }

    template <class Pipe>
    bool set_halt(Pipe& pipe, bool is_halted)
    {
        if (is_halted)
            pipe.halt(controller_);
        else
            pipe.open(controller_);
        return true;
    }

    bool set_idle(std::uint8_t duration)
    {
        idle_ = duration;
        return true;
    }

    void open_pipes()
    {
        to_computer_.open(controller_);
        from_computer_.open(controller_);
    }

    void disconnect()
    {
        is_configured_ = false;
        idle_ = 0;
        to_computer_.close();
        from_computer_.close();
        controller_.close(Endpoint::reports_in);
        controller_.close(Endpoint::reports_out);
    }

    static constexpr std::uint16_t index_of(Endpoint endpoint) { return static_cast<std::uint8_t>(endpoint); }

    bool is_our_interface(const SetupPacket& packet) const { return is_configured_ && packet.index == 0; }
    /// Reports have no numbers: 0 represents all.
    bool is_our_report(const SetupPacket& packet) const
    {
        return is_our_interface(packet) && packet.value_low() == 0;
    }

    C controller_;
    ControlPipe control_;
    ReportsFromComputer<room_from_computer> from_computer_;
    ReportsToComputer<room_to_computer> to_computer_;
    alignas(4) std::array<std::byte, string_descriptor_bytes> answer_{};
    DeviceNames names_;
    std::optional<std::uint8_t> new_address_; ///< counts from the end of the transfer on
    std::uint8_t idle_ = 0;                   ///< kept for the computer alone: nothing is ever repeated
    volatile bool is_configured_ = false;
    volatile bool is_suspended_ = false;
    volatile std::uint32_t connections_ = 0;
};

}
