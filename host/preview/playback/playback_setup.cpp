#include "host/preview/playback/playback_setup.hpp"

#include "host/walk/key_times.hpp"

#include <utility>

namespace kfast {

namespace {

std::vector<InputKnob> inputs_of(const SceneView& scene)
{
    std::vector<InputKnob> knobs;
    std::uint32_t number = 0;
    for (InputCursor inputs = scene.inputs(); !inputs.at_end(); ++number) {
        InputView input = inputs.next();
        const std::string name{std::exchange(input.name, {})};
        if (input.type != InputType::drawing)
            knobs.push_back({name, number, input, input.default_value});
    }
    return knobs;
}

}

PlaybackSetup playback_setup_of(const SceneView& scene)
{
    std::vector<Part> parts{{"", play_range_of(scene)}};
    for (ClipCursor clips = scene.clips(); !clips.at_end();) {
        const ClipView clip = clips.next();
        parts.push_back({std::string{clip.name}, play_range_of(clip)});
    }
    return {scene.frame_rate(), std::move(parts), shown_key_times(scene), scene.events(), inputs_of(scene)};
}

}
