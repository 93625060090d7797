#pragma once

#include "firmware/usb/controller.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace kfast::usb {

/// The stages of a control transfer. After its setup come data, if any, and then an empty packet in the other
/// direction, by which the receiver acknowledges them.
class ControlPipe {
public:
    // One of these follows a setup.

    /// Sends `data`, or as much as the computer has room for. They must not change until the next setup.
    template <UsbController C>
    void answer(C& controller, std::span<const std::byte> data, std::size_t room)
    {
        if (room == 0)
            return acknowledge(controller);
        left_ = data.first(std::min(data.size(), room));
        needs_end_ = data.size() < room;
        stage_ = Stage::sending;
        send_packet(controller);
    }

    /// Waits for data of at most packet_bytes.
    template <UsbController C>
    void expect(C& controller)
    {
        stage_ = Stage::receiving;
        controller.accept(Endpoint::control_out);
    }

    /// Acknowledges that all is done.
    template <UsbController C>
    void acknowledge(C& controller)
    {
        stage_ = Stage::acknowledging;
        controller.give(Endpoint::control_in, {});
    }

    template <UsbController C>
    void refuse(C& controller)
    {
        stage_ = Stage::idle;
        controller.stall(Endpoint::control_in);
        controller.stall(Endpoint::control_out);
    }

    // The controller calls these.

    /// A packet was sent. Returns whether the computer knows now that all is done.
    template <UsbController C>
    bool sent(C& controller)
    {
        if (stage_ != Stage::sending)
            return std::exchange(stage_, Stage::idle) == Stage::acknowledging;
        go_on(controller);
        return false;
    }

    /// A packet has come. Returns whether it is one that expect() waits for; acknowledge() or refuse()
    /// follows then.
    bool received() { return std::exchange(stage_, Stage::idle) == Stage::receiving; }

private:
    enum class Stage : std::uint8_t { idle, sending, receiving, acknowledging };

    template <UsbController C>
    void go_on(C& controller)
    {
        if (!left_.empty() || needs_end_)
            return send_packet(controller);
        stage_ = Stage::idle;
        controller.accept(Endpoint::control_out); // the computer acknowledges them
    }

    template <UsbController C>
    void send_packet(C& controller)
    {
        const auto packet = left_.first(std::min<std::size_t>(left_.size(), packet_bytes));
        left_ = left_.subspan(packet.size());
        if (packet.size() < packet_bytes) // which signals to the computer that no more will come
            needs_end_ = false;
        controller.give(Endpoint::control_in, packet);
    }

    std::span<const std::byte> left_;
    bool needs_end_ = false; ///< there are fewer data than the computer has room for
    Stage stage_ = Stage::idle;
};

}
