#include "host/commands/summary.hpp"

#include "core/player.hpp"
#include "host/counted.hpp"
#include "host/every_item.hpp"
#include "host/picture/timeline.hpp"

namespace kfast {

std::string contents_summary(const SceneFile& scene)
{
    const auto frames = static_cast<std::size_t>(timeline_of(scene.view).frame_count());
    return counted(scene.bytes.size(), "byte") + ", " + counted(frames, "frame") + ", " +
           counted(object_count(scene.view), "object");
}

std::string summary(const SceneFile& scene)
{
    const Size canvas = scene.view.canvas();
    return contents_summary(scene) + ", " + counted(Player::block_bytes(scene.view, canvas), "byte") +
           " of memory at " + std::to_string(canvas.width) + 'x' + std::to_string(canvas.height);
}

}
