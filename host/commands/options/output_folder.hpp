#pragma once

#include <filesystem>

namespace kfast {

/// Makes it, unless it is there. Throws Failure.
void make_output_folder(const std::filesystem::path& folder);

}
