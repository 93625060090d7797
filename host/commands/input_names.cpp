#include "host/commands/input_names.hpp"

namespace kfast {

std::vector<std::string_view> input_names(const SceneView& scene, InputType type)
{
    std::vector<std::string_view> names;
    for (InputCursor inputs = scene.inputs(); !inputs.at_end();)
        if (const InputView input = inputs.next(); input.type == type)
            names.push_back(input.name);
    return names;
}

}
