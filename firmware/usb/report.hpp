#pragma once

#include <array>
#include <cstddef>

namespace kfast::usb {

inline constexpr std::size_t report_bytes = 64;

/// What is sent from the computer to the device, or back, at once. It has no report id before it.
using Report = std::array<std::byte, report_bytes>;

}
