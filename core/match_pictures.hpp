#pragma once

#include "core/traced_picture.hpp"

#include <cstdint>

namespace kfast {

/// Finds for the steps of each of two pictures what the other one has in their place, and how these differ.
///
/// `moved` has a bit for each input that has moved from one to the other.
///
/// Partners never cross: where all partners have the same coverage and colour, and what has no partner covers
/// nothing, both pictures are the same, whatever belongs together.
void match(TracedPicture& shown, TracedPicture& coming, std::uint32_t moved);

}
