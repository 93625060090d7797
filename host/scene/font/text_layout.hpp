#pragma once

#include "core/scene/input_view.hpp"
#include "host/geometry/outline.hpp"
#include "host/geometry/path_ruler.hpp"
#include "host/scene/font/font_shelf.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kfast::scene {

/// Where a text lies in height.
enum class VerticalAlign : std::uint8_t {
    baseline, ///< `at` is on the baseline of the first line
    top,      ///< at the top of the capitals of the first line
    middle,   ///< in the middle between that and the baseline of the last line
    bottom,   ///< on the baseline of the last line
};

/// How a text is set. All lengths in pixels.
struct TextStyle {
    Font* font = nullptr;
    Vec2 at;         ///< where `align` and `vertical` say
    double size = 0; ///< of the em
    Align align = Align::left;
    double spacing = 0; ///< added between letters
    double leading = 0; ///< from one baseline to the next
    VerticalAlign vertical = VerticalAlign::baseline;
    /// The baseline, of one line; then `at` counts for nothing, and `align` is about `start`, in pixels along
    /// it.
    std::shared_ptr<const PathRuler> along = {};
    double start = 0;

    /// Of the first of `lines` lines.
    double first_baseline(std::size_t lines) const;
};

/// The lines of `text`; they end with LF.
std::vector<std::u32string> lines_of(std::string_view text);

/// How much of a line is to the left of its place.
double share_left_of_anchor(Align align);

/// How wide the line is, in pixels. The font must have all of its characters.
double width_of(std::u32string_view line, const TextStyle& style);

/// The strokes of `text`, letter by letter, line by line; lines end with LF. The font must have all of its
/// characters. Nothing when there are more than `points_left` points.
std::optional<std::vector<Outline>> set_text(std::string_view text, const TextStyle& style,
                                             std::size_t points_left);

}
