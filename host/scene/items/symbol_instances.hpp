#pragma once

#include "host/scene/context/scene_context.hpp"
#include "host/scene/model.hpp"

namespace kfast::scene {

/// Puts the symbols that the items of `scene` use into it, each after those that it uses: once for each time
/// that it goes by somewhere, and each step of its colours. Their keys, and those of objects, then go by the
/// scene's clocks.
///
///     symbol blink                    symbols: blink by the time of the scene
///     use blink                                blink by clock 0
///     use blink delay=12              clocks:  0, twelve frames late
///     use blink delay=12
///
/// What is beyond the format's limits is reported. The skeletons of the scene have been put into it.
void add_symbol_instances(Scene& scene, SceneContext& context);

}
