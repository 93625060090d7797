#pragma once

#include "host/synfig/reading/layer.hpp"

#include <optional>

namespace kfast::synfig {

/// For a layer with a spline all of whose points are linked to bones, each point with its tangents to one:
/// the skin of its drawing of frame 0. Nothing if it must be baked instead: if points also move by
/// themselves, are under a skeleton deformation or have a time of their own, or if bones scale their
/// descendants.
std::optional<art::Skin> linked_skin(const Layer& layer);

}
