#pragma once

#include "core/moment.hpp"
#include "core/scene_view.hpp"
#include "core/time.hpp"

#include <vector>

namespace kfast {

/// A moment of a scene, with where its inputs stand.
struct MeasuredMoment {
    Time time;
    std::vector<Time> inputs;

    Moment moment() const { return {time, inputs}; }
};

/// At which the outlines of a scene are measured: four moments of each frame, or 4000 in all if the scene is
/// long, and wherever it may change at once: the time of every key of drawings, backbones and tracks, and the
/// tick before. Inputs stand at their usual places then; where a scene has some, the same follows with inputs
/// anywhere, and each of them goes all its way at eight times of the scene.
std::vector<MeasuredMoment> measured_moments(const SceneView& scene);

}
