#include "tests/bench/image/harness/sampler.hpp"
#include "tests/bench/image/measured_scene.hpp"

namespace kfast::bench {

Result<std::uint32_t> profile_scene(const SceneView& scene, const Workspace& workspace)
{
    Sampler sampler;
    return measure(scene, workspace, sampler, report_frame);
}

}
