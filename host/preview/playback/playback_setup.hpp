#pragma once

#include "core/playhead.hpp"
#include "core/scene/input_view.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace kfast {

/// An input of a scene that is no drawing; if it is a number, keys change it. Values are in 1/1000.
struct InputKnob {
    std::string name;
    std::uint32_t number = 0; ///< of the input
    InputView range;          ///< without its name
    std::int32_t value = 0;
    std::string text = {};  ///< only for a text
    bool is_turned = false; ///< by the user, since the scene was opened

    bool can_turn() const { return range.type == InputType::number; }

    /// Changes it by a twentieth of its range for each step.
    void turn(int steps)
    {
        const std::int64_t step = std::max((std::int64_t{range.max} - range.min) / 20, std::int64_t{1});
        is_turned = true;
        put(value + steps * step);
    }

    /// Sets it as near as its range allows.
    void put(std::int64_t wanted)
    {
        value =
            static_cast<std::int32_t>(std::clamp(wanted, std::int64_t{range.min}, std::int64_t{range.max}));
    }

    Time place() const { return range.place_of(value); }
};

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
