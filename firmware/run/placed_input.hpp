#pragma once

#include "core/time/time.hpp"

#include <cstdint>

namespace kfast {

/// The value that an input of a scene is set to.
struct PlacedInput {
    std::uint32_t number = 0; ///< less than SceneView::input_count()
    Time place;               ///< 0 … whole_input
};

}
