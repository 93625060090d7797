#include "core/input_check.hpp"

#include "core/kfb_limits.hpp"

namespace kfast {

bool inputs_are_sound(const SceneView& scene)
{
    const auto is_value = [](std::int32_t value) {
        return value >= -kfb::max_input_value && value <= kfb::max_input_value;
    };
    InputCursor inputs = scene.inputs();
    while (!inputs.at_end()) {
        const InputView input = inputs.next();
        if (inputs.rest().overrun() || input.name.empty() || !is_value(input.least) ||
            !is_value(input.most) || input.most <= input.least || input.usual < input.least ||
            input.usual > input.most)
            return false;
    }
    return scene.input_count() <= kfb::max_inputs && inputs.rest().left() == 0;
}

}
