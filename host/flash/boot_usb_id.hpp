#pragma once

#include <cstdint>

/// The numbers by which a computer identifies the boot loaders of chips of Raspberry Pi.
namespace kfast::boot_usb {

inline constexpr std::uint16_t vendor_id = 0x2e8a;
inline constexpr std::uint16_t rp2040_id = 0x0003;
inline constexpr std::uint16_t rp2350_id = 0x000f;

}
