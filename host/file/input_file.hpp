#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace kfast {

/// Few files that kfast reads come near it; a larger one was named by mistake.
inline constexpr std::size_t input_limit = std::size_t{16} << 20;

/// Much less than of a compiled scene, for a parsed text takes up to 90 times its size in memory.
inline constexpr std::size_t max_scene_text_bytes = std::size_t{4} << 20;

/// What a file is to be, for the messages.
struct InputKind {
    std::string_view noun;   ///< "scene"
    std::string_view files;  ///< which files are such: "a .kfast or .kfb file"
    std::string_view begins; ///< what would be in it: "a scene begins with …"
    std::size_t max_bytes = input_limit;
};

/// What a scene is loaded from.
inline constexpr std::string_view scene_files =
    "a .kfast or .kfb file, or a .json, .lottie, .svg or .sif file";

inline constexpr InputKind scene_input{"scene", scene_files, "a scene begins with 'kfast 1' and a canvas"};
inline constexpr InputKind font_input{"font", "a .ttf or .otf file", "copy it again"};

/// The content of a file. Throws Failure when it cannot be read, is empty, or larger than its kind allows.
std::string read_input(const std::filesystem::path& path, const InputKind& kind);

}
