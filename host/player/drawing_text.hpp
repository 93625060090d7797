#pragma once

#include "host/player/received_drawing.hpp"

#include <string>
#include <string_view>
#include <variant>

namespace kfast {

/// What `text` says, as in "10,20 30,40 / 50,60 70,80": points in pixels with blanks or new lines between
/// them, and a / between strokes. Nothing but blanks is the empty drawing. Points are rounded to 1/16 px,
/// halves away from zero. In place of a drawing, what is wrong with the text.
std::variant<ReceivedDrawing, std::string> read_drawing(std::string_view text);

}
