#include "host/commands/input_names.hpp"

namespace kfast {

std::vector<std::string_view> input_names(const SceneView& scene)
{
    std::vector<std::string_view> names;
    for (InputCursor inputs = scene.inputs(); !inputs.at_end();)
        names.push_back(inputs.next().name);
    return names;
}

}
