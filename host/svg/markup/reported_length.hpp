#pragma once

#include "host/art/losses.hpp"
#include "host/svg/markup/length.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace kfast::svg {

/// Of coordinates in a file: further away nothing is seen, and squares of it are still finite.
inline constexpr double farthest = 1e7;

/// The length that a property or attribute has, held within `farthest`; nothing where it is not set or
/// "auto". A text that is no length is nothing as well, and a loss of the layer.
std::optional<double> reported_length(std::string_view name, std::string_view text, Axis axis,
                                      const Measure& measure, const std::string& layer, art::Losses& losses);

}
