#pragma once

#include "core/playhead.hpp"
#include "host/preview/playback/input_knob.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace kfast {

/// A part of a scene that can be played by itself.
struct Part {
    std::string name; ///< of a clip; the whole scene has none
    PlayRange stretch;
};

/// What a preview can play, and how it begins.
struct PlaybackSetup {
    std::uint32_t frame_rate = 30000;           ///< frames in 1000 seconds
    std::vector<Part> parts;                    ///< the whole scene, then its clips
    std::vector<Time> keys;                     ///< in order
    EventCursor events;                         ///< looks into the scene's bytes
    std::vector<InputKnob> inputs = {};         ///< all numbers of the scene
    std::size_t first = 0;                      ///< the part to begin with
    std::int32_t speed = Playhead::as_authored; ///< not 0
};

PlaybackSetup playback_setup_of(const SceneView& scene);

}
