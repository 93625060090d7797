#pragma once

#include "host/scene/model.hpp"
#include "host/text/source.hpp"

#include <cstddef>
#include <string_view>
#include <vector>

namespace kfast::scene {

/// An input that has been read.
struct InputEntry {
    Input input;
    SourceSpan place;
    bool is_used = false;       ///< keys go by it
    bool is_range_known = true; ///< else it was wrong
};

/// The inputs of a scene in their order.
struct InputTable {
    std::vector<InputEntry> entries = {};

    InputEntry* find(std::string_view name)
    {
        for (InputEntry& entry : entries)
            if (entry.input.name == name)
                return &entry;
        return nullptr;
    }
};

}
