#pragma once

#include <cstdint>

/// The numbers by which a computer knows the device.
namespace kfast::usb {

inline constexpr std::uint16_t vendor_id = 0x1209; // pid.codes, which gives numbers to open projects
inline constexpr std::uint16_t product_id = 0x0001;

/// pid.codes reserves these for tests at home: nobody may hand out devices that have them.
inline constexpr bool is_test_id = vendor_id == 0x1209 && product_id >= 0x0001 && product_id <= 0x0010;

#ifdef KFAST_RELEASE
static_assert(!is_test_id, "a release needs a product id of its own, and this one is for development alone");
#endif

}
