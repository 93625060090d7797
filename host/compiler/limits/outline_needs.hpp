#pragma once

#include "host/compiler/write/header.hpp"
#include "host/program/progress_callback.hpp"
#include "host/scene/model.hpp"
#include "host/text/diagnostic.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace kfast {

/// What the outlines of any one picture of `scene` need on any panel, at most kfb::max_outline_bytes and
/// kfb::max_borders. `file` is the scene compiled, valid but for these figures in its header. If a picture
/// finds no room even with the coarsest curves, that is an error at the largest object, and nothing is
/// returned.
///
/// Found by playing the scene (host/compiler/limits/measured_moments.hpp), with the worst content of live
/// drawings (host/compiler/limits/outline_meter.hpp), and adding an eighth: a time between two of these may
/// halve a few curves once more. A player whose picture still finds no room draws it with coarser curves.
/// That is most of the work of compiling, and `on_progress` is called for it.
std::optional<OutlineNeeds> outline_needs(std::vector<std::byte> file, const scene::Scene& scene,
                                          Diagnostics& diagnostics,
                                          const ProgressCallback& on_progress = ignore_progress);

}
