// Plugs a device that is shared over USB/IP into the kernel that this runs on, as `usbip attach` does:
//
//     vhci-attach HOST:PORT SOCKET        one of the kernel's sockets for devices of full speed, 0 ... 7

#include "tests/emulation/hidapi/usbip_attachment.hpp"

#include <fstream>
#include <iostream>

namespace {

constexpr const char* controller = "/sys/devices/platform/vhci_hcd.0/attach";
constexpr int full_speed = 2;

}

int main(int count, char** words)
{
    if (count != 3) {
        std::cerr << "usage: vhci-attach HOST:PORT SOCKET\n";
        return 2;
    }
    using kfast::test::UsbIpAttachment;
    const auto device = UsbIpAttachment::attach(words[1]);
    if (!device) {
        std::cerr << "vhci-attach: no device is shared at " << words[1] << '\n';
        return 1;
    }
    std::ofstream kernel{controller}; // which keeps the connection
    kernel << words[2] << ' ' << device->socket() << ' ' << UsbIpAttachment::device_number << ' '
           << full_speed << std::flush;
    if (!kernel) {
        std::cerr << "vhci-attach: the kernel does not take it: is socket " << words[2] << " free?\n";
        return 1;
    }
}
