#include "host/words/written_moment.hpp"

#include "host/words/in_frames.hpp"

namespace kfast {

InputView input_of(const SceneView& scene, Driver driver)
{
    InputCursor inputs = scene.inputs();
    for (int before = 1; before < driver.input; ++before)
        inputs.next();
    return inputs.next();
}

double written_moment(const SceneView& scene, Driver driver, Time moment)
{
    if (driver.is_time())
        return in_frames(moment);
    const InputView input = input_of(scene, driver);
    const double share = static_cast<double>(moment.ticks) / whole_input.ticks;
    return (input.min + share * (static_cast<double>(input.max) - input.min)) / 1000;
}

}
