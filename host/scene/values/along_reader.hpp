#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/model.hpp"

#include <optional>

namespace kfast::scene {

/// What the item of `track along "DATA"` follows. Nothing when it is no single stroke with an extent, which
/// is reported.
std::optional<Path> read_along_path(const kdl::Value& data, SceneContext& context);

}
