#pragma once

#include "host/preview/painter.hpp"

#include <span>
#include <string>

namespace kfast {

/// The keys and what they do, over the middle of `room`: in two columns if one would be too long. `rows`
/// begin with the name of a key, then at least one space.
void draw_help(Painter& painter, Rect room, std::span<const std::string> rows);

/// What went wrong, at the upper edge of `room`: long lines are wrapped, and lines for which there is no
/// room left out, which "…" tells.
void draw_errors(Painter& painter, Rect room, std::span<const std::string> lines);

/// One line in the middle of the lower edge of `room`; with a bar that is filled to a share from 0 to 1.
void draw_notice(Painter& painter, Rect room, const std::string& text);
void draw_progress(Painter& painter, Rect room, const std::string& text, double share);

}
