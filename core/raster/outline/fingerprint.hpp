#pragma once

#include "core/raster/outline/grid.hpp"

#include <cstdint>
#include <span>

namespace kfast::raster {

/// Tells whether two layers have the same outlines: 64 bits of the corners of all contours in their order, or
/// of what they are made of. Others that agree in them would be taken for the same; one of 1.8e19 pairs does.
class Fingerprint {
public:
    void add(std::int32_t first, std::int32_t second)
    {
        const auto a = static_cast<std::uint32_t>(first);
        const auto b = static_cast<std::uint32_t>(second);
        // Two independent multiplicative hashes (as FNV-1a, on words): odd factors lose nothing.
        high_ = (high_ ^ a) * 0x9E37'79B1U + b;
        low_ = (low_ ^ b) * 0x85EB'CA77U + a;
        high_ ^= high_ >> 15;
        low_ ^= low_ >> 13;
    }
    void add(std::span<const Corner> contour)
    {
        for (const Corner& corner : contour)
            add(corner.x, corner.y);
        high_ = (high_ + 1) * 0xC2B2'AE3DU;
        low_ = (low_ ^ 1) * 0x27D4'EB2FU;
    }

    friend constexpr bool operator==(Fingerprint, Fingerprint) = default;

private:
    // Not 0, which corners at the origin would leave as it is.
    std::uint32_t high_ = 0x6A09'E667;
    std::uint32_t low_ = 0xBB67'AE85;
};

}
