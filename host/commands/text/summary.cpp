#include "host/commands/text/summary.hpp"

#include "core/player.hpp"
#include "host/commands/text/quantity_text.hpp"
#include "host/picture/timeline.hpp"
#include "host/text/number_text.hpp"
#include "host/walk/every_item.hpp"
#include "host/words/scene_words.hpp"

namespace kfast {

std::vector<std::string_view> clip_names(const SceneView& scene)
{
    std::vector<std::string_view> names;
    for (ClipCursor clips = scene.clips(); !clips.at_end();)
        names.push_back(clips.next().name);
    return names;
}

std::string length_text(const SceneView& scene)
{
    const double frames = in_frames(timeline_of(scene).stretch.end);
    return rounded_text(frames) + (frames == 1 ? " frame" : " frames");
}

std::string contents_summary(const SceneFile& scene)
{
    return counted(scene.bytes.size(), "byte") + ", " + length_text(scene.view) + ", " +
           counted(object_count(scene.view), "object");
}

std::string summary(const SceneFile& scene)
{
    const Size canvas = scene.view.canvas();
    return contents_summary(scene) + ", " + counted(Player::block_bytes(scene.view, canvas), "byte") +
           " of memory at " + size_text(canvas);
}

}
