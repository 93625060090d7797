#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// Memory for the outlines of any one picture of a compiled scene, which is sound but for this figure in its
/// header: a multiple of 4, at most kfb::max_outline_bytes.
std::uint32_t outline_bytes(std::span<const std::byte> file);

}
