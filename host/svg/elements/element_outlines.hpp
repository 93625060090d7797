#pragma once

#include "host/art/budget.hpp"
#include "host/art/geometry/drawing.hpp"
#include "host/art/losses.hpp"
#include "host/svg/markup/length.hpp"
#include "host/svg/style/style.hpp"

#include <string>
#include <string_view>

namespace kfast::svg {

/// Whether an element of that name is a shape.
bool is_shape(std::string_view name);

/// What a shape draws, in its own coordinates. Empty where SVG draws nothing, as for a radius of 0; the data
/// of a path is used up to its first error, which is a loss of the layer.
art::Drawing outlines_of(pugi::xml_node shape, const Style& style, const Measure& measure,
                         const std::string& layer, art::Budget& budget, art::Losses& losses);

}
