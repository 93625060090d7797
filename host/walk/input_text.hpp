#pragma once

#include "core/scene/scene_view.hpp"
#include "core/time/time.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace kfast {

/// The text that the input has until another is set, in UTF-8.
std::string default_text(const TextInput& input);

/// One character as often as the input allows, in UTF-8.
std::string full_text(const TextInput& input, std::uint32_t glyph);

/// How many points each glyph of a text has, in all labels that show the input `number` together, those of a
/// symbol counted once.
std::vector<std::size_t> glyph_points(const SceneView& scene, std::uint32_t number, const TextInput& input);

/// Where the input `number`, a number, has most points in all labels that show it together; nothing if there
/// are none.
std::optional<Time> largest_number_place(const SceneView& scene, std::uint32_t number);

}
