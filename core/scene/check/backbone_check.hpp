#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// Of a drawing that has been checked, at an offset in a scene's section of drawings: three strokes of lines
/// for each backbone, with as many points, at least two.
bool are_backbones(std::span<const std::byte> drawings, std::uint32_t offset);

}
