#pragma once

#include "host/compiler/pack/stroke_steps.hpp"

#include <cstddef>
#include <vector>

namespace kfast {

/// The form of a stroke as the core's PackedDrawing reads it (docs/format.md, "Strokes"), in as few bytes as
/// it takes.
std::vector<std::byte> packed_form(const Steps& steps);

}
