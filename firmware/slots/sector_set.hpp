#pragma once

#include "core/bytes/expects.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace kfast {

/// Some of the sectors of a pool, by their numbers in it.
struct SectorSet {
    static constexpr std::uint32_t capacity = 512;

    std::array<std::byte, capacity / 8> bits{}; ///< sector 0 is the lowest bit of the first byte

    /// `sector` is less than `capacity`.
    constexpr bool has(std::uint32_t sector) const
    {
        expects(sector < capacity);
        return (bits[sector / 8] & bit(sector)) != std::byte{0};
    }
    /// `sector` is less than `capacity`.
    constexpr void add(std::uint32_t sector)
    {
        expects(sector < capacity);
        bits[sector / 8] |= bit(sector);
    }
    friend constexpr bool operator==(const SectorSet&, const SectorSet&) = default;

private:
    static constexpr std::byte bit(std::uint32_t sector) { return std::byte{1} << sector % 8; }
};

}
