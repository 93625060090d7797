#pragma once

#include <cstdint>

namespace kfast::usb {

/// One direction of packets between computer and device, by its address: "in" is to the computer.
enum class Endpoint : std::uint8_t {
    control_out = 0x00,
    control_in = 0x80,
    reports_out = 0x01,
    reports_in = 0x81,
};

constexpr bool is_in(Endpoint endpoint) { return (static_cast<unsigned>(endpoint) & 0x80) != 0; }
constexpr unsigned number_of(Endpoint endpoint) { return static_cast<unsigned>(endpoint) & 0x7F; }

/// The packet size of all endpoints.
inline constexpr std::uint8_t packet_bytes = 64;

}
