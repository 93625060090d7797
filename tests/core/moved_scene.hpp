#pragma once

#include "core/pose/posed_bones.hpp"
#include "core/pose/scene_state.hpp"
#include "core/prepared/prepared_scene.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace kfast::test {

/// A scene, prepared, and its bones; moved to any moment.
class MovedScene {
public:
    /// `scene` must outlive it.
    explicit MovedScene(const SceneView& scene)
        : scene_{scene},
          memory_(PreparedScene::bytes_for(scene) / 4),
          prepared_{scene, std::as_writable_bytes(std::span{memory_})},
          spaces_(scene.records().spaces),
          bones_(scene.bone_count())
    {
        set_up_bones(scene, prepared_, bones_);
    }
    MovedScene(const MovedScene&) = delete;

    const PreparedScene& at(const SceneTime& moment)
    {
        prepared_.move_to(scene_, moment, 0);
        return prepared_;
    }
    /// Posed.
    const std::vector<PosedBone>& bones_at(const SceneTime& moment)
    {
        pose_bones(scene_, at(moment), bones_);
        return bones_;
    }
    /// Whose canvas is as large as the panel; nothing is told from outside.
    SceneOnPanel on_panel_at(const SceneTime& moment)
    {
        bones_at(moment);
        SceneOnPanel shown = on_panel(scene_, scene_.canvas(), Fit::none);
        shown.prepared = prepared_;
        shown.spaces = spaces_;
        shown.bones = bones_;
        shown.inputs = moment.inputs();
        return shown;
    }

private:
    const SceneView& scene_;
    std::vector<std::uint32_t> memory_;
    PreparedScene prepared_;
    std::vector<Space> spaces_;
    std::vector<PosedBone> bones_;
};

}
