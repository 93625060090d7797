#pragma once

#include "host/geometry/outline.hpp"

#include <optional>
#include <string_view>
#include <vector>

namespace kfast::svg {

/// What lengths are measured by.
struct Measure {
    double width = 100; ///< of the nearest view box, in its units
    double height = 100;
    double font_size = 16;
    double root_font_size = 16; ///< of the outermost element
};

/// What of the view box a percentage is of.
enum class Axis { x, y, diagonal };

/// "12", "12px", "3mm", "50%" ... in the units of the coordinates around, at 96 to the inch. Nothing where
/// that is no length.
std::optional<double> length(std::string_view text, Axis axis, const Measure& measure);

/// A number with nothing behind it but space.
std::optional<double> number(std::string_view text);

/// A number, or a percentage of 1.
std::optional<double> share(std::string_view text);

/// Numbers with space or commas between them, as far as they can be read.
std::vector<double> numbers(std::string_view text);
/// The same; `rest` is what cannot be read.
std::vector<double> numbers(std::string_view text, std::string_view& rest);

/// Without space at both ends.
std::string_view trimmed(std::string_view text);

}
