#pragma once

#include "host/art/losses.hpp"
#include "host/svg/markup/svg_text.hpp"
#include "host/svg/style/colour.hpp"
#include "host/svg/style/style.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace kfast::svg {

/// What `property`, "fill" or "stroke", paints with; nothing if it paints nothing. For a gradient it is the
/// mean colour, a loss of the layer, as is a pattern.
std::optional<Ink> paint(std::string_view property, const Style& style, const ElementIndex& index,
                         StyleSheet& sheet, const std::string& layer, art::Losses& losses);

}
