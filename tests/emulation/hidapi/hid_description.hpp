#pragma once

#include "tests/emulation/hidapi/usbip_attachment.hpp"

#include <optional>
#include <string>

namespace kfast::test {

/// What a device with one HID interface says of itself.
struct HidDescription {
    unsigned short vendor = 0;
    unsigned short product = 0;
    unsigned short release = 0;
    unsigned short usage_page = 0;
    unsigned short usage = 0;
    int interface = 0;
    unsigned input = 0; // the endpoints
    unsigned output = 0;
    std::size_t input_bytes = 0;
    std::wstring manufacturer;
    std::wstring name;
    std::wstring serial_number;
};

/// Asks the device, which is configured after that. Null if it is no HID device, or is gone.
std::optional<HidDescription> describe(UsbIpAttachment& device);

}
