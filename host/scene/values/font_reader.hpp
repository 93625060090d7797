#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/font/font.hpp"

namespace kfast::scene {

/// The font that `value` names: a bundled one, or a file in the scene's folder or below it. Reports what is
/// wrong and then returns null.
Font* read_font(const kdl::Value& value, SceneContext& context);

}
