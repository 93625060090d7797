#include "host/commands/inputs/input_names.hpp"

namespace kfast {

std::vector<std::string_view> input_names(const SceneView& scene, InputType type)
{
    std::vector<std::string_view> names;
    for (InputCursor inputs = scene.inputs(); !inputs.at_end();)
        if (const InputView input = inputs.next(); input.type == type)
            names.push_back(input.name);
    return names;
}

std::size_t end_of_input_name(std::string_view text, const SceneView& scene)
{
    std::size_t end = std::string_view::npos;
    for (InputCursor inputs = scene.inputs(); !inputs.at_end();) {
        const std::string_view name = inputs.next().name;
        const bool fits = text.starts_with(name) && text.substr(name.size()).starts_with('=');
        if (fits && (end == std::string_view::npos || name.size() > end))
            end = name.size();
    }
    return end != std::string_view::npos ? end : text.rfind('=');
}

}
