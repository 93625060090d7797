#pragma once

#include "host/art/budget.hpp"
#include "host/art/document/document.hpp"
#include "host/art/document/extent.hpp"
#include "host/art/losses.hpp"
#include "host/scene_text/values/reach.hpp"

#include <cstdint>
#include <vector>

namespace kfast::scene_text {

/// Throws Failure if a number of the document is infinite or NaN.
void check_finite(const art::Document& document);

/// What is known of a symbol that has been arranged.
struct ArrangedSymbol {
    bool draws = false;
    bool has_line = false;
    int depth = 0;      ///< of nested groups and uses
    art::Extent extent; ///< of what it draws
};

struct Arranging {
    std::int32_t length = 0; ///< of the scene, or of the symbol that is arranged, in ticks
    double tolerance = 0;    ///< pixels
    art::Losses& losses;
    art::Budget& budget; ///< of what is computed
    std::vector<ArrangedSymbol> symbols = {};
};

/// Brings nodes into a form in which each is one item of a scene: those of symbols, and of the document.
Reach arrange(art::Document& document, Arranging arranging);

}
