#pragma once

#include <span>
#include <string_view>

namespace kfast {

/// A scene that is part of this program, to go on from: a file of examples/gallery.
struct SceneTemplate {
    std::string_view name; ///< of that file, without its ending
    std::string_view text; ///< all of that file; valid as long as the program runs

    /// What it is, on one line: its first comment, without the "// ".
    std::string_view summary() const;
};

/// All scenes of the gallery, in the order of docs/gallery.md. There is at least one.
std::span<const SceneTemplate> scene_templates();

/// The text of starter.kfast, a small scene for beginners that has more comments than those of the gallery.
extern const std::string_view starter_scene;

}
