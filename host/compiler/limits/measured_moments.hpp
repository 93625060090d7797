#pragma once

#include "core/scene/scene_view.hpp"
#include "core/time/time.hpp"

#include <cstddef>
#include <vector>

namespace kfast {

/// A time of a scene, with the values of its inputs, and of its clocks if they are not those of the time.
struct MeasuredMoment {
    Time time;
    std::vector<Time> inputs;
    std::vector<Time> clocks = {};

    SceneTime moment() const { return {time, inputs, clocks}; }
};

/// The times at which the outlines of a scene are measured: four in each frame, or 4000 in all if the scene
/// is long, and wherever it may change abruptly: the time of every key of drawings, backbones and tracks, and
/// the tick before; of keys that go by a clock, when it first comes to them, and 32 times of its own. Inputs
/// have their default values then, and once more, if labels show numbers, those with the most points. Where a
/// scene has inputs, moments at any time follow: each input alone at up to 256 values; all at their minimum
/// and all at their maximum; and 1500 combinations, in which most of them are at an end or at a key. How long
/// drawing them takes is not considered: thin_out() leaves fewer.
std::vector<MeasuredMoment> measured_moments(const SceneView& scene);

/// How many pictures of the scene, whose outlines need so many bytes, are laid out in about one and a half
/// seconds.
std::size_t affordable_pictures(const SceneView& scene, std::size_t outline_bytes);

/// Leaves at most `count` of them, spread evenly: at least the first and the last.
void thin_out(std::vector<MeasuredMoment>& moments, std::size_t count);

}
