#pragma once

#include "host/scene/model.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace kfast::test {

/// A text and what reading it gave.
struct SceneText {
    std::optional<scene::Scene> scene;
    /// A line each, such as `3:8 error: unknown colour "blu" (did you mean "blue"?)`.
    std::string findings;
};

/// Parses and reads a whole scene.
SceneText read(std::string_view text);

/// The same with `kfast 1` and `canvas 100 100` as the first two lines.
SceneText read_on_canvas(std::string_view text);

/// The drawing of one key or still object, in pixels: `M 10 10 L 20.5 10 C 1 2 3 4 5 6 M …`.
std::string text_of(const scene::Drawing& drawing);

/// The drawing of an object that holds the node `shape`, then what was found; the shape's line is 1.
std::string drawn(std::string_view shape);
/// The same for the data of a path; column 1 is its first character.
std::string path_drawn(std::string_view data);

}
