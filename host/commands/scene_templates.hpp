#pragma once

#include <span>
#include <string_view>

namespace kfast {

/// A scene that is part of this program, to go on from: a file of examples/gallery.
struct SceneTemplate {
    std::string_view name; ///< of that file, without its ending
    std::string_view text;

    /// What it is, on one line: its first comment, without the "// ".
    std::string_view summary() const;
};

/// All of them, in the order of docs/gallery.md.
std::span<const SceneTemplate> scene_templates();

/// The text of starter.kfast: a small scene with more comments than those, for who begins.
extern const std::string_view starter_scene;

}
