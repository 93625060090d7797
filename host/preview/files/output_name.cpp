#include "host/preview/files/output_name.hpp"

#include "host/picture/timeline.hpp"

#include <algorithm>
#include <unistd.h>

namespace kfast {
namespace {

namespace fs = std::filesystem;

bool is_there(const fs::path& file)
{
    std::error_code unknown;
    return fs::exists(fs::symlink_status(file, unknown));
}

/// Where new files go.
fs::path folder_beside(const fs::path& scene)
{
    const fs::path folder = scene.parent_path();
    return folder.empty() || ::access(folder.c_str(), W_OK | X_OK) == 0 ? folder : fs::path{};
}

bool is_plain(char letter)
{
    constexpr std::string_view harmless = "-_.";
    const auto byte = static_cast<unsigned char>(letter);
    const bool is_ascii_word = (letter >= '0' && letter <= '9') || (letter >= 'a' && letter <= 'z') ||
                               (letter >= 'A' && letter <= 'Z');
    return is_ascii_word || byte >= 0x80 || harmless.find(letter) != std::string_view::npos;
}

}

fs::path new_output_name(const fs::path& scene, const std::string& suffix, const std::string& extension)
{
    std::error_code unknown;
    const bool is_file = fs::is_regular_file(scene, unknown);
    const std::string stem = is_file ? scene.stem().string() : "scene";
    const fs::path folder = is_file ? folder_beside(scene) : fs::path{};
    fs::path name = folder / (stem + suffix + extension);
    for (int number = 2; is_there(name); ++number)
        name = folder / (stem + suffix + '-' + std::to_string(number) + extension);
    return name;
}

std::string frame_suffix(int frame) { return '-' + frame_digits(frame); }

std::string plain_name(std::string_view name)
{
    std::string plain{name};
    std::ranges::replace_if(
        plain, [](char letter) { return !is_plain(letter); }, '_');
    return plain;
}

}
