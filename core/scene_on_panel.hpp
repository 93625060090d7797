#pragma once

#include "core/canvas_map.hpp"
#include "core/evaluator/prepared_scene.hpp"
#include "core/live_backbones.hpp"
#include "core/live_bones.hpp"
#include "core/live_drawings.hpp"
#include "core/live_texts.hpp"
#include "core/projection.hpp"
#include "core/rigid_placement.hpp"
#include "core/scene_view.hpp"
#include "core/size.hpp"
#include "core/space.hpp"

#include <span>

namespace kfast {

/// What the pictures of a scene on one panel have in common.
struct SceneOnPanel {
    SceneView scene;
    PreparedScene prepared{};  ///< at the moment of the picture
    Space canvas;              ///< from the canvas to the panel
    std::span<Space> spaces{}; ///< room for those of placed items in each other, for one walk at a time
    Camera camera;
    RigidPlacements rigid;
    std::span<LiveBone> bones{}; ///< of all skeletons; set up
    std::span<BackboneNode> backbone_nodes{};
    LiveDrawings drawings{}; ///< from outside
    LiveTexts texts{};       ///< likewise
};

/// Without anything that moves. The canvas lies on the panel as `fit` wants it, and the viewer in front of
/// its middle.
SceneOnPanel on_panel(const SceneView& scene, Size panel, Fit fit);

}
