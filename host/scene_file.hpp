#pragma once

#include "core/scene_view.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace kfast {

/// A scene read from disk. `view` looks into `bytes`, hence no copies.
struct SceneFile {
    SceneFile(std::vector<std::byte> compiled, SceneView checked) : bytes{std::move(compiled)}, view{checked}
    {
    }
    SceneFile(SceneFile&&) = default;
    SceneFile(const SceneFile&) = delete;

    std::vector<std::byte> bytes; ///< a .kfb
    SceneView view;
    bool was_text = false;               ///< compiled just now, rather than read as a .kfb
    std::size_t warnings = 0;            ///< of the compiler
    std::vector<std::string> item_names; ///< in the order in which the scene stores items; only of a text
};

/// Reads a compiled scene (known by its first bytes, "KFB") or reads and compiles a scene text, whatever the
/// file's name. What the compiler finds is printed to standard error, in colour on a terminal.
/// Throws Failure when the file cannot be read, is empty or larger than 16 MB (a text: 4 MB), or is no valid
/// scene.
SceneFile load_scene(const std::filesystem::path& path);

}
