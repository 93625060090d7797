#pragma once

#include "core/math/point.hpp"

#include <optional>
#include <string>

namespace kfast {

/// Where something in a controller's memory lies: there, and on the glass.
struct GlassPlace {
    int column = 0;
    int row = 0;
    int x = 0;
    int y = 0;

    /// What is wrong with a pixel there.
    std::optional<std::string> mistake(Size glass) const
    {
        if (x >= 0 && x < glass.width && y >= 0 && y < glass.height)
            return std::nullopt;
        return "a pixel outside the glass: column " + std::to_string(column) + ", row " +
               std::to_string(row) + " of the memory";
    }
};

}
