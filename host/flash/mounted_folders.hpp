#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace kfast {

/// Where file systems are mounted that a drive which is plugged in may have, as /proc/self/mountinfo tells
/// it. No network is asked.
std::vector<std::filesystem::path> mounted_folders(std::string_view mountinfo);

}
