#pragma once

#include "host/compiler/carry/key_tween.hpp"
#include "host/scene/model.hpp"
#include "host/text/diagnostic.hpp"

#include <vector>

namespace kfast {

/// The ways of `object`, which has backbones, in coordinates relative to these (docs/format.md, "Backbones").
/// `drawn` are the same ways as they are without backbones. Points that lie in no cell are a warning at their
/// key; a way that takes more points than a drawing holds is an error there.
KeyTweens deformed_tweens(const scene::Object& object, const std::vector<KeyTween>& drawn,
                          Diagnostics& diagnostics);

}
