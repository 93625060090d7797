#pragma once

#include "host/preview/painter.hpp"

#include <string_view>

namespace kfast {

/// Fills the pane with one line of text; it is cut where it is too long.
void draw_status(Painter& painter, Rect pane, std::string_view text);

}
