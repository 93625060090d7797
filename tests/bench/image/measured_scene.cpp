#include "tests/bench/image/measured_scene.hpp"

#include "tests/bench/image/harness/instruction_meter.hpp"

namespace kfast::bench {

Result<std::uint32_t> measure_scene(const SceneView& scene, const Workspace& workspace)
{
    InstructionMeter meter;
    meter.begin();
    return measure(scene, workspace, meter, report_frame);
}

}
