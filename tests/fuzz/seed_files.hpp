#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace kfast::test {

/// What is in these files, and in those of these folders, in the order of their names. Where one cannot be
/// read, or there is none, the program ends with status 2.
std::vector<std::vector<std::byte>> read_files(std::span<const std::string> files_and_folders);

/// Those of them that begin as a compiled scene does, though they may be broken.
std::vector<std::vector<std::byte>> read_scenes(std::span<const std::string> files_and_folders);

}
