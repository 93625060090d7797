#pragma once

#include "core/moment.hpp"
#include "core/scene_view.hpp"
#include "core/time.hpp"
#include "host/scene/model.hpp"
#include "host/text/diagnostic.hpp"

namespace kfast {

/// Reports that the outlines at `moment` do not fit what the format allows, at the object that has most of
/// them. `view` is `scene` compiled.
void report_excess(const scene::Scene& scene, const SceneView& view, const Moment& moment,
                   Diagnostics& diagnostics);

}
