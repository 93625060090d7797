#pragma once

#include "host/program/progress_callback.hpp"
#include "host/scene/model.hpp"
#include "host/text/diagnostic.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace kfast {

/// The bytes of a .kfb (docs/format.md). A scene that exceeds the format's limits on items, points, steps or
/// outlines is an error at its largest object.
std::optional<std::vector<std::byte>> write_scene(const scene::Scene& scene, Diagnostics& diagnostics,
                                                  const ProgressCallback& on_progress = ignore_progress);

}
