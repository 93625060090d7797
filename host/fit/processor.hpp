#pragma once

#include <cstddef>
#include <cstdint>

namespace kfast::fit {

/// A kind of CPU, as far as it decides what code is compiled for it. The Cortex-M0+ runs what the M0 runs.
enum class Processor : std::uint8_t { cortex_m0, cortex_m3, cortex_m4, cortex_m7, cortex_m33 };

inline constexpr std::size_t processor_count = 5;

}
