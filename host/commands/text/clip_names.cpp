#include "host/commands/text/clip_names.hpp"

namespace kfast {

std::vector<std::string_view> clip_names(const SceneView& scene)
{
    std::vector<std::string_view> names;
    for (ClipCursor clips = scene.clips(); !clips.at_end();)
        names.push_back(clips.next().name);
    return names;
}

}
