#pragma once

#include "host/scene/model.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

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

/// The object that lies at `index` on the outermost level.
const scene::Object& object_at(const scene::Scene& scene, std::size_t index = 0);
const scene::Key& key_at(const scene::Scene& scene, std::size_t index = 0);

/// Every item on a line of its own, two spaces deeper inside a group: its kind and name (of a use, the name
/// of its symbol), the times of its drawings in frames, and its tracks with values in their stored units:
///
///     object o @0,30 x[0:0 30:160(accelerate,constant)]
///     group scale_x[8192]
///       use eye visible[0:1 2.5:0]
///
/// A time and a colon are left out in a track of one key at 0, laws where both are constant. A ~ stands
/// behind the name of a smooth track, and a path behind the tracks: `path(M 0 0 L 5 5)`, or `turning(…)`.
std::string text_of(const scene::Scene& scene, const std::vector<scene::Item>& items);
/// The items of the outermost level, then what was found; the first line of `text` is 1.
std::string items_read(std::string_view text);

/// Every bone of the first skeleton on a line of its own: its name, that of its parent, "tip" if it is fixed
/// to its tip, angle, x, y and length as set up, and the keys of those that have some, in their stored units:
///
///     torso 49152 1920 2400 960
///     arm <torso tip 0 960 0 512 angle[0:0 12:56434]
///
/// Then what was found. `text` is what stands inside of `bones s`; its first line is 1.
std::string bones_read(std::string_view text, std::string_view properties = "");

/// What the points of the first object's first drawing follow, "a b a|b:128": a point that follows several
/// bones has the weights in 1/256 behind all but the heaviest. Then what was found, in the lines of `text`.
///
/// `text` follows on a skeleton `s` of an upright bone `a` from 20 80 to 20 40, and `b`, which lies at its
/// tip and ends at 60 40, each with a region of 10 px.
std::string skin_read(std::string_view text);

/// The drawing of one key or still object, in pixels: `M 10 10 L 20.5 10 C 1 2 3 4 5 6 M …`.
std::string text_of(const scene::Drawing& drawing);

/// The drawing of an object that holds the node `shape`, then what was found; the shape's line is 1.
std::string drawn(std::string_view shape);
/// The same for a scene in `folder`.
std::string drawn_in(const std::optional<std::string>& folder, std::string_view shape);
/// The same for the data of a path; column 1 is its first character.
std::string path_drawn(std::string_view data);

}
