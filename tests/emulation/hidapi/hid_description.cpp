#include "tests/emulation/hidapi/hid_description.hpp"

namespace kfast::test {
namespace {

constexpr unsigned char device_descriptor = 1;
constexpr unsigned char configuration_descriptor = 2;
constexpr unsigned char text_descriptor = 3;
constexpr unsigned char interface_descriptor = 4;
constexpr unsigned char endpoint_descriptor = 5;
constexpr unsigned char report_descriptor = 0x22;
constexpr unsigned char hid_class = 3;

constexpr unsigned char of_device = 0x80;
constexpr unsigned char of_interface = 0x81;
constexpr unsigned short english = 0x0409;

unsigned short word(const Bytes& bytes, std::size_t at)
{
    return static_cast<unsigned short>(bytes[at] | bytes[at + 1] << 8);
}

Bytes descriptor(UsbIpAttachment& device, unsigned char whose, unsigned char kind, unsigned char number,
                 unsigned short index, unsigned char length)
{
    const auto low = static_cast<unsigned char>(index & 0xFF);
    const auto high = static_cast<unsigned char>(index >> 8);
    return device.control({whose, 6, number, kind, low, high, length, 0}).value_or(Bytes{});
}

std::wstring text(UsbIpAttachment& device, unsigned char number)
{
    const Bytes bytes = descriptor(device, of_device, text_descriptor, number, english, 255);
    std::wstring result;
    for (std::size_t at = 2; at + 1 < bytes.size(); at += 2)
        result += static_cast<wchar_t>(word(bytes, at));
    return result;
}

void read_endpoint(const unsigned char* bytes, HidDescription& description)
{
    const unsigned number = bytes[2] & 0x0FU;
    if ((bytes[2] & 0x80) == 0) {
        description.output = number;
        return;
    }
    description.input = number;
    description.input_bytes = static_cast<std::size_t>(bytes[4] | bytes[5] << 8);
}

/// The interface and its endpoints. Whether there is one of the class HID.
bool read_configuration(const Bytes& bytes, HidDescription& description)
{
    bool found = false;
    for (std::size_t at = 0; at + 2 <= bytes.size() && bytes[at] >= 2 && at + bytes[at] <= bytes.size();
         at += bytes[at]) {
        if (bytes[at + 1] == interface_descriptor && bytes[at] >= 9 && bytes[at + 5] == hid_class) {
            found = true;
            description.interface = bytes[at + 2];
        }
        if (bytes[at + 1] == endpoint_descriptor && bytes[at] >= 7)
            read_endpoint(&bytes[at], description);
    }
    return found;
}

/// The first value of an item in the description of reports, of whatever size; 0 if there is none.
unsigned short item(const Bytes& bytes, unsigned char kind)
{
    constexpr unsigned char sizes = 3;
    for (std::size_t at = 0; at < bytes.size();) {
        const std::size_t count = (bytes[at] & sizes) == sizes ? 4 : bytes[at] & sizes;
        if ((bytes[at] & ~sizes) == kind && at + count < bytes.size())
            return count >= 2 ? word(bytes, at + 1)
                              : static_cast<unsigned short>(count == 1 ? bytes[at + 1] : 0);
        at += 1 + count;
    }
    return 0;
}

/// As a kernel does it when a device is plugged in; who comes later leaves it as it is.
bool configure(UsbIpAttachment& device, unsigned char number)
{
    const auto now = device.control({of_device, 8, 0, 0, 0, 0, 1, 0});
    return now == Bytes{number} || device.control({0x00, 9, number, 0, 0, 0, 0, 0});
}

}

std::optional<HidDescription> describe(UsbIpAttachment& device)
{
    const Bytes own = descriptor(device, of_device, device_descriptor, 0, 0, 18);
    const Bytes configuration = descriptor(device, of_device, configuration_descriptor, 0, 0, 255);
    HidDescription description;
    if (own.size() != 18 || configuration.size() < 9 || !read_configuration(configuration, description))
        return std::nullopt;
    description.vendor = word(own, 8);
    description.product = word(own, 10);
    description.release = word(own, 12);
    if (!configure(device, configuration[5]))
        return std::nullopt;
    description.manufacturer = text(device, own[14]);
    description.name = text(device, own[15]);
    description.serial_number = text(device, own[16]);
    const auto reports = descriptor(device, of_interface, report_descriptor, 0,
                                    static_cast<unsigned short>(description.interface), 255);
    constexpr unsigned char usage_page = 0x04;
    constexpr unsigned char usage = 0x08;
    description.usage_page = item(reports, usage_page);
    description.usage = item(reports, usage);
    return description;
}

}
