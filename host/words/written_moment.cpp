#include "host/words/written_moment.hpp"

#include "host/words/in_frames.hpp"

namespace kfast {

InputView input_of(const SceneView& scene, Clock clock)
{
    InputCursor inputs = scene.inputs();
    for (int before = 1; before < clock.input; ++before)
        inputs.next();
    return inputs.next();
}

double written_moment(const SceneView& scene, Clock clock, Time moment)
{
    if (clock.is_time())
        return in_frames(moment);
    const InputView input = input_of(scene, clock);
    const double share = static_cast<double>(moment.ticks) / whole_input.ticks;
    return (input.least + share * (static_cast<double>(input.most) - input.least)) / 1000;
}

}
