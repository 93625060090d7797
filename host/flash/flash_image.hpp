#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <span>
#include <string>
#include <vector>

namespace kfast {

/// "0x10001000", with more digits where eight are too few.
inline std::string hex_text(std::uint64_t value)
{
    std::array<char, 20> text{};
    std::snprintf(text.data(), text.size(), "0x%08llx", static_cast<unsigned long long>(value));
    return text.data();
}

/// Bytes and their address in a chip's memory.
struct FlashRegion {
    std::uint32_t address = 0;
    std::vector<std::byte> bytes;

    friend bool operator==(const FlashRegion&, const FlashRegion&) = default;
};

/// What is to be in flash: whole sectors of 4 KiB in the order of their addresses, padded with 0xFF. Sectors
/// that no region touches stay as they are.
class FlashImage {
public:
    static constexpr std::size_t sector_bytes = 4096; ///< that are erased at once
    static constexpr std::size_t page_bytes = 256;    ///< that are written at once

    struct Sector {
        std::uint32_t address = 0; ///< a multiple of sector_bytes
        std::array<std::byte, sector_bytes> bytes{};
    };

    /// Throws std::invalid_argument when a sector belongs to two regions or a region ends beyond 32 bits.
    explicit FlashImage(std::span<const FlashRegion> regions);

    std::span<const Sector> sectors() const { return sectors_; }

private:
    std::vector<Sector> sectors_;
};

}
