#pragma once

#include "core/pose/live_drawing.hpp"

#include <vector>

namespace kfast {

/// A live drawing as it is told: its strokes.
using ToldDrawing = std::vector<std::vector<LivePoint>>;

/// Its strokes, as a player takes them; they live as long as the drawing.
inline std::vector<LiveStroke> strokes_of(const ToldDrawing& drawing)
{
    return {drawing.begin(), drawing.end()};
}

/// What `drawing` shows.
inline ToldDrawing told_drawing(const LiveDrawing& drawing)
{
    ToldDrawing strokes;
    for (std::uint32_t number = 0; number < drawing.strokes(); ++number) {
        const LiveStroke stroke = drawing.stroke(number);
        strokes.emplace_back(stroke.begin(), stroke.end());
    }
    return strokes;
}

}
