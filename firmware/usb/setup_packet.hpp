#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast::usb {

inline constexpr std::size_t setup_bytes = 8;

/// What a control transfer begins with.
struct SetupPacket {
    std::uint16_t kind;  ///< type of the request, and its number in the low byte: see request
    std::uint16_t value; ///< these two as defined by the request
    std::uint16_t index;
    std::uint16_t length; ///< of the data that follow, or that the computer has room for

    static constexpr SetupPacket parse(std::span<const std::byte, setup_bytes> bytes)
    {
        const auto word = [bytes](std::size_t low, std::size_t high) {
            return static_cast<std::uint16_t>(std::to_integer<unsigned>(bytes[low]) |
                                              std::to_integer<unsigned>(bytes[high]) << 8);
        };
        return {word(1, 0), word(2, 3), word(4, 5), word(6, 7)};
    }

    constexpr std::uint8_t value_low() const { return static_cast<std::uint8_t>(value); }
    constexpr std::uint8_t value_high() const { return static_cast<std::uint8_t>(value >> 8); }
};

/// Values of SetupPacket::kind.
namespace request {

inline constexpr std::uint16_t get_device_status = 0x8000;
inline constexpr std::uint16_t get_interface_status = 0x8100;
inline constexpr std::uint16_t get_endpoint_status = 0x8200;
inline constexpr std::uint16_t clear_endpoint_feature = 0x0201;
inline constexpr std::uint16_t set_endpoint_feature = 0x0203;
inline constexpr std::uint16_t set_address = 0x0005;
inline constexpr std::uint16_t get_descriptor = 0x8006;
inline constexpr std::uint16_t get_interface_descriptor = 0x8106;
inline constexpr std::uint16_t get_configuration = 0x8008;
inline constexpr std::uint16_t set_configuration = 0x0009;
inline constexpr std::uint16_t get_interface = 0x810A;
inline constexpr std::uint16_t set_interface = 0x010B;
// Of the class HID
inline constexpr std::uint16_t get_report = 0xA101;
inline constexpr std::uint16_t get_idle = 0xA102;
inline constexpr std::uint16_t set_report = 0x2109;
inline constexpr std::uint16_t set_idle = 0x210A;

}

}
