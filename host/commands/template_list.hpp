#pragma once

#include "host/commands/scene_templates.hpp"

#include <span>
#include <string>

namespace kfast {

/// A line for each: its name, and what it is.
std::string template_lines(std::span<const SceneTemplate> templates);

/// For tools: an array of objects with name, summary, and the names of inputs and clips; with its line end.
std::string template_json(std::span<const SceneTemplate> templates);

/// A small picture of each with its name below, side by side in the terminal that standard output is: what is
/// seen in the middle of the scene, drawn by half blocks in the terminal's colours.
std::string template_pictures(std::span<const SceneTemplate> templates);

}
