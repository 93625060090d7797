#pragma once

#include "host/preview/painter/painter.hpp"
#include "host/preview/viewer/viewer.hpp"

#include <optional>
#include <string>

namespace kfast {

inline constexpr const char* this_computer = "this computer";

/// What a preview shows at the right of its own picture.
struct Beside {
    const Picture& picture; ///< valid as long as the scene that is open
    std::string
        caption; ///< "board: the same picture", or how many pixels differ from what the panel holds now
};

/// None where the scene was opened without pictures of another panel.
std::optional<Beside> beside(Viewer& viewer);

/// Both as one, of the same height, with a gap.
Picture joined(const Picture& left, const Picture& right);
/// The first column of the right picture, where joined() is shown in `columns` columns.
int right_column(const Picture& left, const Picture& right, int columns);

/// Draws it in the middle of the lower edge of a pane.
void draw_caption(Painter& painter, Rect pane, const std::string& text);

}
