#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace kfast {

/// Bytes and where they belong in a chip's memory.
struct FlashRegion {
    std::uint32_t address = 0;
    std::vector<std::byte> bytes;

    friend bool operator==(const FlashRegion&, const FlashRegion&) = default;
};

}
