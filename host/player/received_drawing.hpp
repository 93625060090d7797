#pragma once

#include "core/pose/input_drawing.hpp"

#include <vector>

namespace kfast {

/// A live drawing as it comes: its strokes.
using ReceivedDrawing = std::vector<std::vector<InputPoint>>;

/// Its strokes, as a player takes them; they live as long as the drawing.
inline std::vector<InputStroke> strokes_of(const ReceivedDrawing& drawing)
{
    return {drawing.begin(), drawing.end()};
}

/// What `drawing` shows.
inline ReceivedDrawing received_drawing(const InputDrawing& drawing)
{
    ReceivedDrawing strokes;
    for (std::uint32_t number = 0; number < drawing.strokes(); ++number) {
        const InputStroke stroke = drawing.stroke(number);
        strokes.emplace_back(stroke.begin(), stroke.end());
    }
    return strokes;
}

}
