#pragma once

#include "host/scene/context/scene_context.hpp"
#include "host/scene/model.hpp"

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace kfast::scene {

/// The bone that is called `name`; reports it at `place` if there is none.
std::optional<std::size_t> read_bone_name(std::string_view name, SourceSpan place,
                                          const std::vector<Bone>& bones, SceneContext& context);

}
