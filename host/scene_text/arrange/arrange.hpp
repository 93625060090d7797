#pragma once

#include "host/art/budget.hpp"
#include "host/art/document/document.hpp"
#include "host/art/losses.hpp"
#include "host/scene_text/values/reach.hpp"

#include <cstdint>
#include <vector>

namespace kfast::scene_text {

/// Throws Failure if a number of the document is infinite or NaN.
void check_finite(const art::Document& document);

struct Arranging {
    std::int32_t length = 0; ///< of the scene, in ticks
    double tolerance = 0;    ///< pixels
    art::Losses& losses;
    art::Budget& budget; ///< of what is computed
};

/// Brings nodes into a form in which each is one item of a scene.
Reach arrange(std::vector<art::Node>& nodes, const Arranging& arranging);

}
