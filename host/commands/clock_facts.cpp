#include "host/commands/clock_facts.hpp"

namespace kfast {

void tell_input(const SceneView& scene, Clock clock, nlohmann::ordered_json& facts)
{
    if (!clock.is_time())
        facts["input"] = input_of(scene, clock).name;
}

}
