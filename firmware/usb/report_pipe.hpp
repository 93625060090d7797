#pragma once

#include "firmware/usb/controller.hpp"
#include "firmware/usb/report_ring.hpp"

#include <cstddef>

namespace kfast::usb {

/// What reports in both directions have in common: a ring of them, one of which the controller may have at a
/// time, and an endpoint that is open or not, and halted or not.
template <Endpoint endpoint, std::size_t room>
class ReportPipe {
public:
    bool is_halted() const { return is_halted_; }

    /// Nothing comes or goes any more, and what is in the ring is dropped.
    void close()
    {
        ring_.clear();
        is_open_ = false;
        is_at_controller_ = false;
    }

    template <UsbController C>
    void halt(C& controller)
    {
        controller.stall(endpoint);
        is_halted_ = true;
        is_at_controller_ = false;
    }

protected:
    /// The first packet is DATA0; nothing is halted. What is in the ring stays.
    template <UsbController C>
    void begin(C& controller)
    {
        controller.open(endpoint);
        is_open_ = true;
        is_halted_ = false;
        is_at_controller_ = false;
    }

    ReportRing<room> ring_;
    bool is_open_ = false;
    bool is_halted_ = false;
    bool is_at_controller_ = false; ///< the next place in the ring, or its first report
};

}
