#pragma once

#include "host/scene/model.hpp"

namespace kfast {

/// Puts the strokes of every object that shows one drawing all the time, stroked and not filled, in an order
/// in which a beam travels little between them (core/beam/beam_route.hpp), turns some of them round and
/// begins closed ones elsewhere. The longest travel lies behind the last stroke, where a beam goes on to
/// another object. Objects that a skeleton carries stay as they are, and so do wire frames.
void order_strokes(scene::Scene& scene);

/// Likewise of one drawing.
void order_strokes(scene::Drawing& drawing);

}
