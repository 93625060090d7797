#pragma once

#include "firmware/report.hpp"
#include "firmware/usb/endpoint.hpp"
#include "firmware/usb/usb_id.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

/// What the device reports about itself: USB 2.0, chapter 9, and the class HID 1.11.
namespace kfast::usb {

/// The kind of a descriptor, and its second byte.
enum class DescriptorType : std::uint8_t {
    device = 1,
    configuration = 2,
    string = 3,
    interface = 4,
    endpoint = 5,
    hid = 0x21,
    report = 0x22,
};

/// The numbers of the strings.
enum class StringIndex : std::uint8_t { languages = 0, maker = 1, product = 2, serial = 3 };

namespace descriptor_detail {

/// Each value is a byte, or an enumerator that represents one.
template <class... Values>
constexpr std::array<std::byte, sizeof...(Values)> bytes(Values... values)
{
    return {static_cast<std::byte>(values)...};
}

constexpr unsigned low(unsigned word) { return word & 0xFF; }
constexpr unsigned high(unsigned word) { return word >> 8; }

}

inline constexpr std::array device_descriptor = [] {
    using namespace descriptor_detail;
    constexpr unsigned usb_version = 0x0200;
    constexpr unsigned device_version = 0x0100;
    constexpr unsigned class_of_interface = 0; // and two bytes that belong to it
    constexpr unsigned configurations = 1;
    return bytes(18, DescriptorType::device, low(usb_version), high(usb_version), class_of_interface, 0, 0,
                 packet_bytes, low(vendor_id), high(vendor_id), low(product_id), high(product_id),
                 low(device_version), high(device_version), StringIndex::maker, StringIndex::product,
                 StringIndex::serial, configurations);
}();

/// Bytes of no meaning to the computer, as many in each direction. Without report ids no byte before them
/// says which report it is.
inline constexpr std::array report_descriptor = [] {
    using namespace descriptor_detail;
    constexpr unsigned vendor_page = 0xFF00;
    constexpr unsigned to_computer = 0x01;
    constexpr unsigned to_device = 0x02;
    return bytes(0x06, low(vendor_page), high(vendor_page), // usage page
                 0x09, 0x01,                                // usage
                 0xA1, 0x01,                                // collection: application
                 0x15, 0x00,                                // logical minimum 0
                 0x26, 0xFF, 0x00,                          // logical maximum 255
                 0x75, 8,                                   // report size in bits
                 0x95, report_bytes,                        // report count
                 0x09, to_computer, 0x81, 0x02,             // usage; input: data, variable, absolute
                 0x09, to_device, 0x91, 0x02,               // usage; output: data, variable, absolute
                 0xC0);                                     // end of collection
}();

inline constexpr std::uint8_t configuration_value = 1;

namespace descriptor_detail {

inline constexpr std::size_t hid_begin = 18;
inline constexpr std::size_t hid_bytes = 9;

}

/// Configuration, interface, HID and both endpoints.
inline constexpr std::array configuration_descriptor = [] {
    using namespace descriptor_detail;
    constexpr unsigned total = 9 + 9 + hid_bytes + 7 + 7;
    constexpr unsigned always_set = 0x80; // and neither powered by itself nor able to wake the computer
    constexpr unsigned current = 500 / 2; // a backlight may need all that there is
    constexpr unsigned hid_class = 3;
    constexpr unsigned hid_version = 0x0111;
    constexpr unsigned interrupt = 3;
    constexpr unsigned every_millisecond = 1;
    return bytes(
        9, DescriptorType::configuration, low(total), high(total), 1, configuration_value, 0, always_set,
        current,                                                   //
        9, DescriptorType::interface, 0, 0, 2, hid_class, 0, 0, 0, //
        hid_bytes, DescriptorType::hid, low(hid_version), high(hid_version), 0, 1, DescriptorType::report,
        low(report_descriptor.size()), high(report_descriptor.size()), //
        7, DescriptorType::endpoint, Endpoint::reports_in, interrupt, packet_bytes, 0,
        every_millisecond, //
        7, DescriptorType::endpoint, Endpoint::reports_out, interrupt, packet_bytes, 0, every_millisecond);
}();

constexpr std::span<const std::byte> hid_descriptor()
{
    using namespace descriptor_detail;
    return std::span{configuration_descriptor}.subspan(hid_begin, hid_bytes);
}

/// The only language.
inline constexpr std::uint16_t english = 0x0409;
inline constexpr std::array languages_descriptor =
    descriptor_detail::bytes(4, DescriptorType::string, english & 0xFF, english >> 8);

inline constexpr std::size_t string_descriptor_bytes = 64;

/// Writes `text` of ASCII as a descriptor, cut off after 31 letters, and returns its length.
constexpr std::size_t write_string_descriptor(std::string_view text,
                                              std::span<std::byte, string_descriptor_bytes> to)
{
    std::size_t size = 2;
    for (const char letter : text.substr(0, string_descriptor_bytes / 2 - 1)) {
        to[size++] = static_cast<std::byte>(letter);
        to[size++] = std::byte{0};
    }
    to[0] = static_cast<std::byte>(size);
    to[1] = static_cast<std::byte>(DescriptorType::string);
    return size;
}

}
