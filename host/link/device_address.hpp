#pragma once

#include <string>

namespace kfast {

/// How a device is reached that has not been opened yet.
struct DeviceAddress {
    enum class Way { usb, socket };

    Way way = Way::usb;
    std::string path;
    std::string serial; ///< of USB alone; a simulated board tells it when it is asked
};

/// How a message calls it.
inline std::string name_of(const DeviceAddress& address)
{
    return address.serial.empty() ? address.path : address.serial;
}

}
