#pragma once

#include "host/art/document/document.hpp"
#include "host/lottie/drawings/extent.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace kfast::lottie {

/// What is written once, and used by nodes: compositions, and what repeaters copy.
struct SymbolTable {
    static constexpr std::size_t max = 200; ///< of the 255 that a scene has for each time that they go by

    std::vector<art::Symbol> list = {}; ///< as Document::symbols
    std::vector<Box> boxes = {};        ///< of each, around all that it ever draws

    bool is_full() const { return list.size() >= max; }

    /// Returns its index.
    std::size_t add(art::Symbol symbol, const Box& box)
    {
        list.push_back(std::move(symbol));
        boxes.push_back(box);
        return list.size() - 1;
    }
};

}
