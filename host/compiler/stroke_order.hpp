#pragma once

#include "host/scene/model.hpp"

namespace kfast {

/// Puts the strokes of every object that shows one drawing all the time, stroked and not filled, in an order
/// in which a beam travels little between them (core/beam/beam_route.hpp), reverses some of them and begins
/// closed ones elsewhere. The longest travel is after the last stroke, where a beam goes on to another
/// object. Objects that a skeleton deforms and wire frames, whose travel depends on how they are rotated,
/// stay as they are.
void order_strokes(scene::Scene& scene);

/// The same for one drawing.
void order_strokes(scene::Drawing& drawing);

}
