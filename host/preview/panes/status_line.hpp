#pragma once

#include "host/preview/painter/painter.hpp"

#include <string_view>

namespace kfast {

/// Fills the pane with one line of text, which is cut where it is too long. `hint` stands at the right edge,
/// if there is room for both.
void draw_status(Painter& painter, Rect pane, std::string_view text, std::string_view hint = {});

}
