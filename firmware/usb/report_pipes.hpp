#pragma once

#include "firmware/report.hpp"
#include "firmware/usb/report_pipe.hpp"

#include <algorithm>
#include <cstddef>
#include <span>

namespace kfast::usb {

/// Reports from the computer. As long as there is room, the controller accepts one more.
template <std::size_t room>
class ReportsFromComputer : public ReportPipe<Endpoint::reports_out, room> {
public:
    /// The first packet is DATA0; nothing is halted. Reports that have come stay.
    template <UsbController C>
    void open(C& controller)
    {
        this->begin(controller);
        accept_more(controller);
    }

    /// Returns false if there is none.
    template <UsbController C>
    bool take(C& controller, Report& report)
    {
        if (ring_.is_empty())
            return false;
        report = ring_.first();
        ring_.pop();
        accept_more(controller);
        return true;
    }

    /// The controller has a packet.
    template <UsbController C>
    void received(C& controller)
    {
        is_at_controller_ = false;
        put(controller, Endpoint::reports_out);
        accept_more(controller);
    }

    /// Puts a packet of the endpoint `from`, which may be another one, after those that have come; returns
    /// false if there is no room for it.
    template <UsbController C>
    bool put(C& controller, Endpoint from)
    {
        if (ring_.free() <= (is_at_controller_ ? 1u : 0u))
            return false;
        Report& report = ring_.next();
        const std::size_t size = controller.read(from, report.bytes);
        std::ranges::fill(std::span{report.bytes}.subspan(size), std::byte{0});
        ring_.push();
        return true;
    }

private:
    using Pipe = ReportPipe<Endpoint::reports_out, room>;
    using Pipe::is_at_controller_;
    using Pipe::ring_;

    template <UsbController C>
    void accept_more(C& controller)
    {
        if (!this->is_open_ || this->is_halted_ || is_at_controller_ || ring_.free() == 0)
            return;
        is_at_controller_ = true;
        controller.accept(Endpoint::reports_out);
    }
};

/// Reports to the computer.
template <std::size_t room>
class ReportsToComputer : public ReportPipe<Endpoint::reports_in, room> {
public:
    /// The first packet is DATA0; nothing is halted. Reports that wait are sent.
    template <UsbController C>
    void open(C& controller)
    {
        this->begin(controller);
        give_next(controller);
    }

    /// Returns false if nobody listens, or there is no room.
    template <UsbController C>
    bool send(C& controller, const Report& report)
    {
        if (!this->is_open_ || ring_.free() == 0)
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
        is_at_controller_ = false;
        give_next(controller);
    }

    /// The report that the computer got last, or zeros.
    const Report& latest() const { return latest_; }

private:
    using Pipe = ReportPipe<Endpoint::reports_in, room>;
    using Pipe::is_at_controller_;
    using Pipe::ring_;

    template <UsbController C>
    void give_next(C& controller)
    {
        if (this->is_halted_ || is_at_controller_ || ring_.is_empty())
            return;
        is_at_controller_ = true;
        controller.give(Endpoint::reports_in, ring_.first().bytes);
    }

    alignas(4) Report latest_{};
};

}
