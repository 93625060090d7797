#pragma once

#include <array>
#include <cstddef>

namespace kfast::usb {

inline constexpr std::size_t report_bytes = 64;

/// What goes from the computer to the device, or back, at once. It has no number of its own in front.
using Report = std::array<std::byte, report_bytes>;

}
