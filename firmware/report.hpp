#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

inline constexpr std::size_t report_bytes = 64;

/// What is sent over the link, in either direction: 64 bytes. Byte 0 is the kind, byte 1 a tag chosen by the
/// computer and repeated by an answer, the rest is payload, little-endian.
struct Report {
    alignas(std::uint32_t) std::array<std::byte, report_bytes> bytes{}; // is copied by words

    constexpr std::uint8_t kind() const { return std::to_integer<std::uint8_t>(bytes[0]); }
    constexpr std::uint8_t tag() const { return std::to_integer<std::uint8_t>(bytes[1]); }
    constexpr std::span<const std::byte> payload() const { return std::span{bytes}.subspan(2); }
    constexpr std::span<std::byte> payload() { return std::span{bytes}.subspan(2); }

    friend constexpr bool operator==(const Report&, const Report&) = default;
};

inline constexpr std::size_t payload_bytes = report_bytes - 2;

/// Set in the kinds of what a device sends.
inline constexpr std::uint8_t from_device = 0x80;

}
