#pragma once

#include "host/preview/controls/help_pages.hpp"
#include "host/preview/painter/painter.hpp"

#include <span>
#include <string>
#include <string_view>

namespace kfast {

/// Fills the pane with one line of text, which is cut where it is too long. `hint` is at the right edge,
/// if there is room for both.
void draw_status(Painter& painter, Rect pane, std::string_view text, std::string_view hint = {});

/// The size of the largest page of help that fits.
Size help_cells(Rect room);
/// Draws it over the middle of `room`.
void draw_help(Painter& painter, Rect room, const HelpPage& page);

/// Draws what went wrong, at the upper edge of `room`: long lines are wrapped, and lines for which there is
/// no room are replaced by "…". Returns the area that it covers.
Rect draw_errors(Painter& painter, Rect room, std::span<const std::string> lines);

/// Draws a text in the middle of the lower edge of `room`, in as many lines as it takes; with a bar that is
/// filled to a fraction from 0 to 1.
void draw_notice(Painter& painter, Rect room, const std::string& text);
void draw_progress(Painter& painter, Rect room, const std::string& text, double share);

}
