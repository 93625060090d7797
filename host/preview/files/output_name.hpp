#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace kfast {

/// The name of a new file that is made of the scene in `scene`: "eyes" + `suffix` + `extension` beside it,
/// with
/// "-2", "-3" ... behind the suffix where there is one already. It is in the current folder if none can be
/// written there, and begins with "scene" if that is no regular file.
std::filesystem::path new_output_name(const std::filesystem::path& scene, const std::string& suffix,
                                      const std::string& extension);

/// "-0012"
std::string frame_suffix(int frame);

/// A part of a name as it may stand in that of a file: what would need quotes in a shell is "_".
std::string plain_name(std::string_view name);

}
