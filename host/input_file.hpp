#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace kfast {

/// Few kinds of files that kfast reads come near it; what is larger was named by mistake.
inline constexpr std::size_t input_limit = std::size_t{16} << 20;

/// What a file is to be, for the messages.
struct InputKind {
    std::string_view noun;   ///< "scene"
    std::string_view files;  ///< which files are such: "a .kfast or .kfb file"
    std::string_view begins; ///< what would stand in it: "a scene begins with …"
    std::size_t most_bytes = input_limit;
};

inline constexpr InputKind scene_input{"scene", "a .kfast or .kfb file",
                                       "a scene begins with 'kfast 1' and a canvas"};
inline constexpr InputKind font_input{"font", "a .ttf or .otf file", "copy it again"};

/// The content of a file. Throws Failure when it cannot be read, is empty, or larger than its kind allows.
std::string read_input(const std::filesystem::path& path, const InputKind& kind);

}
