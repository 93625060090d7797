#pragma once

#include "core/scene/scene_view.hpp"

namespace kfast {

/// The input that `driver` is.
InputView input_of(const SceneView& scene, Driver driver);

/// A moment of keys as an author writes it: in frames, or in the values of the input that they go by.
double written_moment(const SceneView& scene, Driver driver, Time moment);

}
