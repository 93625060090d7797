#pragma once

#include <cstdint>
#include <span>

namespace kfast {

/// Makes a beam dark where it shines and stays in one place: that burns. Works on the points of
/// dac_point.hpp.
class StillLight {
public:
    /// At most `max` points in a row may shine in one place.
    explicit StillLight(std::uint32_t max) : max_{max} {}

    /// The next point, dark if the beam has stayed for too long.
    std::uint32_t passed(std::uint32_t point)
    {
        const bool has_moved = places_ == 0 || place_of(point) != place_;
        if (has_moved) {
            place_ = place_of(point);
            shining_ = 0;
            ++places_;
        }
        if (is_lit(point))
            ++shining_;
        return shining_ > max_ ? place_ : point;
    }

    /// Ends a picture, and begins another one. A picture that stays in one place shines for ever once
    /// it is repeated: then all of it becomes dark.
    void end(std::span<std::uint32_t> picture)
    {
        if (places_ == 1)
            for (std::uint32_t& point : picture)
                point = place_of(point);
        places_ = 0;
    }

private:
    static constexpr std::uint32_t place_of(std::uint32_t point) { return point & 0x00FF'FFFF; }
    static constexpr bool is_lit(std::uint32_t point) { return point >> 24 != 0; }

    std::uint32_t max_;
    std::uint32_t place_ = 0;
    std::uint32_t shining_ = 0;
    std::uint32_t places_ = 0; ///< the places of the picture, until now
};

}
