#pragma once

#include "core/scene/scene_view.hpp"
#include "core/time/time.hpp"
#include "host/compiler/limits/largest_texts.hpp"
#include "host/scene/model.hpp"
#include "host/text/diagnostic.hpp"

#include <cstddef>

namespace kfast {

/// Reports that the outlines at `moment`, with these texts, do not fit what the format allows, at the object
/// that has most of them. `view` is `scene` compiled.
void report_excess(const scene::Scene& scene, const SceneView& view, const SceneTime& moment,
                   const LargestTexts& texts, Diagnostics& diagnostics);

/// Likewise where the worst that live drawings may be, `live` bytes, comes to `bytes` of others; at the
/// one that may have most points.
void report_live_excess(const scene::Scene& scene, const SceneTime& moment, std::size_t bytes,
                        std::size_t live, Diagnostics& diagnostics);

}
