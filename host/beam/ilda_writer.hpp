#pragma once

#include "core/beam/beam_profile.hpp"
#include "host/beam/ilda_format.hpp"

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace kfast {

/// The points of a picture, in the order of drawing.
using BeamPoints = std::vector<BeamPoint>;

/// A file with these frames, in any format but that of palettes. Each has 1 … max_ilda_records points, and
/// there are 1 … max_ilda_records of them. The depth of points is 0. Indexed formats begin with a palette if
/// the colours need one.
///
/// `name` is that of the frames; what is no ASCII of it becomes '_', and what is after eight letters is left
/// out.
std::vector<std::byte> ilda_file(std::string_view name, IldaFormat format,
                                 std::span<const BeamPoints> frames);

}
