#pragma once

#include "firmware/report.hpp"

#include <cstdint>
#include <optional>
#include <string_view>

namespace kfast::pico {

/// The reports that a computer and this board send each other over USB: firmware/usb/hid_device.hpp says
/// more. An interrupt wakes the board when one comes.
class UsbReports {
public:
    /// Shows the computer that the board is there. Needs start_clocks().
    void begin() const;

    /// Unique to the chip. After begin().
    std::string_view serial_number() const;

    std::optional<Report> take() const;
    bool send(const Report& report) const;

    bool is_connected() const;
    std::uint32_t connections() const;
};

/// There is one plug.
inline constexpr UsbReports usb_reports;

}
