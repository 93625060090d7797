#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace kfast::test {

/// Where the body of a compiled scene begins that a checksum covers: the fewest bytes that sealed() takes.
inline constexpr std::size_t sealed_from = 8;

/// The bytes of a compiled scene with a size and a checksum that fit, so that what is tried gets past them.
std::vector<std::byte> sealed(std::span<const std::byte> bytes);

}
