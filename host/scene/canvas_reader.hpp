#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/model.hpp"
#include "host/scene/reading.hpp"

#include <optional>

namespace kfast::scene {

/// Fills the canvas, frame rate and loop of `scene`, puts the background first into the palette and sets the
/// frame rate for the times that follow. Returns the length of the scene if the canvas gives one.
std::optional<Time> read_canvas(const kdl::Node& node, Scene& scene, Reading& reading);

}
