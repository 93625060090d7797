#pragma once

#include <filesystem>

namespace kfast {

/// `output`, unless it is the file that `input` names: then throws Failure, for the scene would be lost.
std::filesystem::path output_path(const std::filesystem::path& output, const std::filesystem::path& input);

}
