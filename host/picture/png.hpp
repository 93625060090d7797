#pragma once

#include "host/picture/picture.hpp"

#include <cstddef>
#include <filesystem>
#include <vector>

namespace kfast {

/// A PNG of 8 bits for each of red, green and blue. Throws Failure when there is no memory.
std::vector<std::byte> encoded_png(const Picture& picture);

/// Throws Failure when the file cannot be written; then there is none.
void write_png(const std::filesystem::path& target, const Picture& picture);

}
