#pragma once

#include "host/commands/templates/scene_templates.hpp"

#include <span>
#include <string>

namespace kfast {

/// Returns a line for each template with its name and its summary.
std::string template_lines(std::span<const SceneTemplate> templates);

/// Returns an array of JSON for tools: objects with `name`, `summary`, and the names of `inputs` and `clips`.
/// The text ends with "\n".
std::string template_json(std::span<const SceneTemplate> templates);

/// Returns a picture of each template, 18 pixels a side, with its name below: half blocks in the colours of
/// the terminal that standard output is, as many side by side as it is wide. Each picture is that of the
/// moment half way through the scene.
std::string template_pictures(std::span<const SceneTemplate> templates);

}
