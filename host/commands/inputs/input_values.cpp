#include "host/commands/inputs/input_values.hpp"

namespace kfast {

InputValues chosen_values(const InputOptions& inputs, const DrawingOptions& drawings, const SceneView& scene)
{
    return {chosen_inputs(inputs, scene), chosen_drawings(drawings, scene)};
}

void put_values(const InputValues& values, const SceneView& scene, InputReceiver& receiver)
{
    put_inputs(values.values, scene, receiver);
    put_drawings(values.drawings, scene, receiver);
}

}
