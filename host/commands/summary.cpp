#include "host/commands/summary.hpp"

#include "core/player.hpp"
#include "host/counted.hpp"
#include "host/every_item.hpp"
#include "host/picture/timeline.hpp"

namespace kfast {

std::string summary(const SceneFile& scene)
{
    const Size canvas = scene.view.canvas();
    return summary(scene, canvas, Player::block_bytes(scene.view, canvas));
}

std::string summary(const SceneFile& scene, Size panel, std::size_t block_bytes)
{
    const auto frames = static_cast<std::size_t>(timeline_of(scene.view).frame_count());
    return counted(scene.bytes.size(), "byte") + ", " + counted(frames, "frame") + ", " +
           counted(object_count(scene.view), "object") + ", " + counted(block_bytes, "byte") +
           " of memory at " + std::to_string(panel.width) + 'x' + std::to_string(panel.height);
}

}
