#pragma once

#include "core/scene/scene_view.hpp"
#include "core/time/time.hpp"

#include <vector>

namespace kfast {

/// A moment of a scene, with where its inputs stand.
struct MeasuredMoment {
    Time time;
    std::vector<Time> inputs;

    SceneTime moment() const { return {time, inputs}; }
};

/// At which the outlines of a scene are measured: four moments of each frame, or 4000 in all if the scene is
/// long, and wherever it may change at once: the time of every key of drawings, backbones and tracks, and the
/// tick before. Inputs stand at their usual places then. Where a scene has some, moments follow at any time:
/// each input alone on its way, at up to 256 places; all at their least and all at their greatest; and 1500
/// combinations, in which most of them stand at an end or at a key. How long drawing them takes is not looked
/// at: thin_out() leaves fewer.
std::vector<MeasuredMoment> measured_moments(const SceneView& scene);

/// How many pictures of the scene are drawn in about one and a half seconds.
std::size_t affordable_pictures(const SceneView& scene);

/// Leaves no more than `count` of them, spread evenly: at least the first and the last.
void thin_out(std::vector<MeasuredMoment>& moments, std::size_t count);

}
