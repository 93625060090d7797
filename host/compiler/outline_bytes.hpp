#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace kfast {

/// Memory for the outlines of any one picture of a compiled scene, which is sound but for this figure in its
/// header: a multiple of 4, at most kfb::max_outline_bytes.
///
/// Found by playing the scene, four moments of each frame, or 4000 in all if it is long, and adding an eighth:
/// a moment between two of these may halve a few curves once more. A player whose picture finds no room all the
/// same draws it with coarser curves.
std::uint32_t outline_bytes(std::vector<std::byte> file);

}
