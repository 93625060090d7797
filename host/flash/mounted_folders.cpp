#include "host/flash/mounted_folders.hpp"

#include <algorithm>
#include <array>
#include <sstream>
#include <string>

namespace kfast {
namespace {

/// FAT, which boot loaders have, by its different drivers. Not memory, as in /tmp, where anybody may leave
/// what looks like a drive.
constexpr std::array<std::string_view, 4> file_systems{"vfat", "msdos", "exfat", "fuseblk"};

bool is_octal(char digit) { return digit >= '0' && digit <= '7'; }

/// The kernel writes spaces and the like as a backslash and three octal digits.
std::string unescaped(std::string_view text)
{
    std::string plain;
    while (!text.empty()) {
        const bool is_escape =
            text.size() >= 4 && text[0] == '\\' && std::ranges::all_of(text.substr(1, 3), is_octal);
        plain += is_escape ? static_cast<char>((text[1] - '0') * 64 + (text[2] - '0') * 8 + (text[3] - '0'))
                           : text[0];
        text.remove_prefix(is_escape ? 4 : 1);
    }
    return plain;
}

}

std::vector<std::filesystem::path> mounted_folders(std::string_view mountinfo)
{
    std::vector<std::filesystem::path> folders;
    std::istringstream lines{std::string{mountinfo}};
    for (std::string line; std::getline(lines, line);) {
        // mount, parent, device, root, folder, options, further fields, "-", file system, …
        std::istringstream words{line};
        std::string word;
        std::string folder;
        for (int field = 0; field < 5; ++field)
            words >> folder;
        while (words >> word && word != "-") {
        }
        if (words >> word && std::ranges::find(file_systems, word) != file_systems.end())
            folders.emplace_back(unescaped(folder));
    }
    return folders;
}

}
