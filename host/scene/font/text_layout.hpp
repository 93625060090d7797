#pragma once

#include "core/scene/input_view.hpp"
#include "host/geometry/outline.hpp"
#include "host/scene/font/font_shelf.hpp"

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace kfast::scene {

/// How a text is set. All lengths in pixels.
struct TextStyle {
    Font* font = nullptr;
    Vec2 at;         ///< on the baseline of the first line, where `align` says
    double size = 0; ///< of the em
    Align align = Align::left;
    double spacing = 0; ///< added between letters
    double leading = 0; ///< from one baseline to the next
};

/// The strokes of `text`, letter by letter, line by line; lines end with LF. The font must have all of its
/// characters. Nothing when there are more than `points_left` points.
std::optional<std::vector<Outline>> set_text(std::string_view text, const TextStyle& style,
                                             std::size_t points_left);

}
