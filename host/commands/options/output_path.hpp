#pragma once

#include <filesystem>
#include <string_view>

namespace kfast {

/// `output`, unless it is the file that `input` names: then throws Failure, for what it holds would be lost:
/// "the scene itself".
std::filesystem::path output_path(const std::filesystem::path& output, const std::filesystem::path& input,
                                  std::string_view what = "scene itself");

}
