#pragma once

#include "host/synfig/reading/layer.hpp"

#include <optional>

namespace kfast::synfig {

/// Of a layer with a spline all of whose points are linked to bones, each point with its tangents to one:
/// what carries its drawing of frame 0. Nothing where it must be baked instead: where points also move by
/// themselves, lie under a skeleton deformation or at a time of their own, or where bones let grow what hangs
/// on them.
std::optional<art::Skin> linked_skin(const Layer& layer);

}
