#pragma once

#include <cstddef>
#include <cstdint>

namespace kfast {

/// What poses move of a bone, in the frame of its parent; the values are those of the scene format.
enum class BoneQuantity : std::uint8_t {
    angle,  ///< clockwise from the parent's direction, in 1/65536 turn
    x,      ///< of the origin, in 1/16 px
    y,      ///< of the origin, in 1/16 px
    length, ///< in 1/16 px
};

inline constexpr std::size_t bone_quantity_count = 4;

}
