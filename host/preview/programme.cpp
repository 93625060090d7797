#include "host/preview/programme.hpp"

#include "host/preview/key_times.hpp"

namespace kfast {

Programme programme_of(const SceneView& scene)
{
    std::vector<Part> parts{{"", stretch_of(scene)}};
    for (ClipCursor clips = scene.clips(); !clips.at_end();) {
        const ClipView clip = clips.next();
        parts.push_back({std::string{clip.name}, stretch_of(clip)});
    }
    return {scene.frame_rate(), std::move(parts), key_times(scene), scene.events()};
}

}
