#pragma once

#include "firmware/usb/controller.hpp"
#include "firmware/usb/report.hpp"
#include "firmware/usb/report_ring.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>

namespace kfast::usb {

/// Reports from the computer. As long as there is room, the controller accepts one more.
template <std::size_t room>
class ReportsFromComputer {
public:
    bool is_halted() const { return is_halted_; }

    /// The first packet is DATA0; nothing is halted. Reports that have come stay.
    template <UsbController C>
    void open(C& controller)
    {
        controller.open(endpoint);
        is_open_ = true;
        is_halted_ = false;
        is_accepting_ = false;
        accept_more(controller);
    }

    /// Nothing comes any more, and what has come is forgotten.
    void close()
    {
        ring_.clear();
        is_open_ = false;
        is_accepting_ = false;
    }

    template <UsbController C>
    void halt(C& controller)
    {
        controller.stall(endpoint);
        is_halted_ = true;
        is_accepting_ = false;
    }

    template <UsbController C>
    std::optional<Report> take(C& controller)
    {
        if (ring_.is_empty())
            return std::nullopt;
        const Report report = ring_.first();
        ring_.pop();
        accept_more(controller);
        return report;
    }

    /// The controller has a packet.
    template <UsbController C>
    void received(C& controller)
    {
        is_accepting_ = false;
        put(controller, endpoint);
        accept_more(controller);
    }

    /// Puts a packet of the endpoint `from`, which may be another one, behind those that have come; false if
    /// there is no room for it.
    template <UsbController C>
    bool put(C& controller, Endpoint from)
    {
        if (ring_.free() <= (is_accepting_ ? 1u : 0u))
            return false;
        Report& report = ring_.next();
        const std::size_t size = controller.read(from, report);
        std::fill(report.begin() + static_cast<std::ptrdiff_t>(size), report.end(), std::byte{0});
        ring_.push();
        return true;
    }

private:
    static constexpr Endpoint endpoint = Endpoint::reports_out;

    template <UsbController C>
    void accept_more(C& controller)
    {
        if (!is_open_ || is_halted_ || is_accepting_ || ring_.free() == 0)
            return;
        is_accepting_ = true;
        controller.accept(endpoint);
    }

    ReportRing<room> ring_;
    bool is_open_ = false;
    bool is_halted_ = false;
    bool is_accepting_ = false; ///< has room in the ring
};

/// Reports to the computer.
template <std::size_t room>
class ReportsToComputer {
public:
    bool is_halted() const { return is_halted_; }

    /// The first packet is DATA0; nothing is halted. Reports that wait are sent.
    template <UsbController C>
    void open(C& controller)
    {
        controller.open(endpoint);
        is_open_ = true;
        is_halted_ = false;
        is_given_ = false;
        give_next(controller);
    }

    /// Nothing is sent any more, and what waits is forgotten.
    void close()
    {
        ring_.clear();
        is_open_ = false;
        is_given_ = false;
    }

    template <UsbController C>
    void halt(C& controller)
    {
        controller.stall(endpoint);
        is_halted_ = true;
        is_given_ = false;
    }

    /// False if nobody listens, or there is no room.
    template <UsbController C>
    bool send(C& controller, const Report& report)
    {
        if (!is_open_ || ring_.free() == 0)
            return false;
        ring_.next() = report;
        ring_.push();
        give_next(controller);
        return true;
    }

    /// The computer has the packet.
    template <UsbController C>
    void sent(C& controller)
    {
        latest_ = ring_.first();
        ring_.pop();
        is_given_ = false;
        give_next(controller);
    }

    /// What the computer got last, or zeros.
    const Report& latest() const { return latest_; }

private:
    static constexpr Endpoint endpoint = Endpoint::reports_in;

    template <UsbController C>
    void give_next(C& controller)
    {
        if (is_halted_ || is_given_ || ring_.is_empty())
            return;
        is_given_ = true;
        controller.give(endpoint, ring_.first());
    }

    ReportRing<room> ring_;
    alignas(4) Report latest_{};
    bool is_open_ = false;
    bool is_halted_ = false;
    bool is_given_ = false; ///< the first report of the ring
};

}
