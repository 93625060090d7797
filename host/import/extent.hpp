#pragma once

#include "host/art/document/document.hpp"

#include <cstddef>

namespace kfast::importing {

/// How much an animation has of what makes a scene large.
struct Extent {
    std::size_t figures = 0;
    std::size_t groups = 0;
    std::size_t keys = 0;   ///< of all that changes
    std::size_t points = 0; ///< in all keys of drawings, as the scene language counts them
};

Extent extent_of(const art::Document& document);

}
