#pragma once

#include "core/time/dependence.hpp"

#include <cstdint>

namespace kfast {

/// A node on the way from the scene to the one at which a walk (SceneWalk) stands. Of one size on all
/// machines, as nodes are.
struct WalkLevel {
    std::uint16_t node = 0;  ///< its number
    std::uint16_t first = 0; ///< nodes that lie within it, by their numbers
    std::uint16_t next = 0;
    std::uint16_t end = 0;
    std::uint8_t opacity = 255;  ///< of its picture if it is blended, else of all that lies within it
    std::uint8_t placed = 0;     ///< so many have spaces of their own, it and those around it
    bool has_space : 1 = false;  ///< that of the last one of these is computed
    bool is_ordered : 1 = false; ///< some of the nodes within it have an order
    bool is_blended : 1 = false; ///< as a whole
    bool is_to_come = false;     ///< a leaf that was not told yet
    std::int32_t order = 0;      ///< of the nodes that are passed now
    std::int32_t next_order = 0; ///< the lowest above it, of those passed
    std::uint32_t path = 0;      ///< see SceneWalk::path()
    Dependence dependence{};     ///< what moves it as a whole
};

static_assert(sizeof(WalkLevel) == 32 && alignof(WalkLevel) == 4);

}
