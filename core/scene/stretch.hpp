#pragma once

#include "core/scene/mark_view.hpp"
#include "core/scene/scene_view.hpp"
#include "core/time/time.hpp"

namespace kfast {

/// A part of a scene's timeline that is played, and what happens at its ends.
struct Stretch {
    Time begin;
    Time end; ///< later than `begin`; both are within 0 … kfb::max_time
    Loop loop = Loop::repeat;

    constexpr Time length() const { return end - begin; }
};

/// The whole scene.
inline Stretch stretch_of(const SceneView& scene) { return {Time{0}, scene.length(), scene.loop()}; }

constexpr Stretch stretch_of(const ClipView& clip) { return {clip.begin, clip.end, clip.loop}; }

}
