#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

/// Of drawings that have been checked, at offsets in a scene's section of drawings.
namespace kfast {

/// As many strokes, with the same segments of the same kinds.
bool is_built_alike(std::span<const std::byte> drawings, std::uint32_t one, std::uint32_t other);

bool has_only_lines(std::span<const std::byte> drawings, std::uint32_t offset);

}
