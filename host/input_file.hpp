#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace kfast {

/// No scene comes near it; what is larger was named by mistake.
inline constexpr std::size_t input_limit = std::size_t{16} << 20;

/// The content of a file. Throws Failure when it cannot be read, is empty, or larger than input_limit.
std::string read_input(const std::filesystem::path& path);

}
