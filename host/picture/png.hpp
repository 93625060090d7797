#pragma once

#include "host/file/atomic_file.hpp"
#include "host/picture/picture.hpp"

#include <cstddef>
#include <filesystem>
#include <string_view>
#include <vector>

namespace kfast {

/// A PNG of 8 bits for each of red, green and blue. Throws Failure when there is no memory.
std::vector<std::byte> encoded_png(const Picture& picture);

/// Any kind of PNG, without its transparency: what is transparent is black below. Throws Failure, which names
/// no file, when it is none, or larger than 4096 pixels at a side.
Picture decoded_png(std::string_view bytes);

/// Throws Failure when the file cannot be written; then there is none.
void write_png(const std::filesystem::path& target, const Picture& picture, Sync sync = Sync::now);

}
