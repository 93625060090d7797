#pragma once

#include "core/pose/input_drawing.hpp"
#include "firmware/report.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace kfast {

/// A live drawing as it is received: its strokes.
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

/// What `text` says, as in "10,20 30,40 / 50,60 70,80": points in pixels with blanks or new lines between
/// them, and a / between strokes. Nothing but blanks is the empty drawing. Points are rounded to 1/16 px,
/// halves away from zero. If the text is invalid, what is wrong with it instead.
std::variant<ReceivedDrawing, std::string> read_drawing(std::string_view text);

/// The reports that send a live drawing to a device, in their order (docs/link.md, "Live drawings"). `number`
/// distinguishes it from the ones before, modulo 8: one more for each drawing of this input. With the tag 0
/// nothing answers them but errors.
std::vector<Report> drawing_reports(const ReceivedDrawing& drawing, std::uint8_t input, std::uint8_t number,
                                    std::uint8_t tag = 0);

}
