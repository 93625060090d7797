#pragma once

#include "core/time/time.hpp"
#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/model.hpp"
#include "host/schema/name_table.hpp"
#include "host/schema/node_schema.hpp"

#include <optional>

namespace kfast::scene {

/// Nothing when the node gives no usable clip of a scene of `length`; what is wrong is reported. `names` are
/// those of the clips before it.
std::optional<Clip> read_clip(const kdl::Node& node, Time length, NameTable& names, SceneContext& context);

NodeSchema clip_words();

}
