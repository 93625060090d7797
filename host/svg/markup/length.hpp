#pragma once

#include "host/art/geometry/affine.hpp"
#include "host/art/losses.hpp"
#include "host/geometry/outline.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kfast::svg {

/// The longest name that is kept, in bytes: files repeat them wherever something is used.
inline constexpr std::size_t longest_name = 255;

/// A text as it is, or its beginning of at most `max` bytes followed by "..."; never half of a character.
std::string shortened(std::string_view text, std::size_t max = 40);

/// What lengths are measured by.
struct Measure {
    double width = 100; ///< of the nearest view box, in its units
    double height = 100;
    double font_size = 16;
    double root_font_size = 16; ///< of the outermost element
};

/// What a percentage refers to in the view box.
enum class Axis { x, y, diagonal };

/// "12", "12px", "3mm", "50%" ... in the units of the coordinates around, at 96 to the inch. Nothing if it is
/// no length.
std::optional<double> length(std::string_view text, Axis axis, const Measure& measure);

/// A number followed by nothing but space.
std::optional<double> number(std::string_view text);

/// A number, or a percentage of 1.
std::optional<double> share(std::string_view text);

/// Numbers with space or commas between them, as far as they can be read.
std::vector<double> numbers(std::string_view text);
/// The same; `rest` is what cannot be read.
std::vector<double> numbers(std::string_view text, std::string_view& rest);

/// Without space at both ends.
std::string_view trimmed(std::string_view text);

/// A part of a drawing's own coordinates.
struct ViewBox {
    double x = 0;
    double y = 0;
    double width = 0; ///< above 0
    double height = 0;
};

/// Nothing where there is none, or one without an extent.
std::optional<ViewBox> view_box(std::string_view text);

/// Maps the box into a rectangle from (0, 0) to (width, height), as "preserveAspectRatio" says.
art::Affine fitted(const ViewBox& box, double width, double height, std::string_view aspect_ratio);

/// The limit of coordinates in a file: farther away nothing is visible, and its squares are still finite.
inline constexpr double farthest = 1e7;

/// The length that a property or attribute has, clamped to `farthest`; nothing where it is not set or "auto".
/// A text that is no length is nothing as well, and a loss of the layer.
std::optional<double> reported_length(std::string_view name, std::string_view text, Axis axis,
                                      const Measure& measure, const std::string& layer, art::Losses& losses);

}
