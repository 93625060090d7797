#pragma once

#include "core/raster/grid.hpp"

#include <cstdint>

namespace kfast::raster {

/// Tells whether two layers have the same outlines: 64 bits of the corners of all contours in their order.
/// Others that agree in them would be taken for the same; one of 1.8e19 pairs does.
class Fingerprint {
public:
    void add(Corner corner)
    {
        // Two independent multiplicative hashes (as FNV-1a, on words): odd factors lose nothing.
        high_ = (high_ ^ static_cast<std::uint32_t>(corner.x)) * 0x9E37'79B1U +
                static_cast<std::uint32_t>(corner.y);
        low_ = (low_ ^ static_cast<std::uint32_t>(corner.y)) * 0x85EB'CA77U +
               static_cast<std::uint32_t>(corner.x);
        high_ ^= high_ >> 15;
        low_ ^= low_ >> 13;
    }
    void end_contour()
    {
        high_ = (high_ + 1) * 0xC2B2'AE3DU;
        low_ = (low_ ^ 1) * 0x27D4'EB2FU;
    }

    friend constexpr bool operator==(Fingerprint, Fingerprint) = default;

private:
    std::uint32_t high_ = 0;
    std::uint32_t low_ = 0;
};

}
