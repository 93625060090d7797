#pragma once

#include "core/math/canvas_map.hpp"
#include "core/math/point.hpp"
#include "core/math/projection.hpp"
#include "core/math/space.hpp"
#include "core/pose/input_drawings.hpp"
#include "core/pose/input_texts.hpp"
#include "core/pose/posed_backbones.hpp"
#include "core/pose/posed_bones.hpp"
#include "core/pose/rigid_placement.hpp"
#include "core/prepared/prepared_scene.hpp"
#include "core/scene/scene_view.hpp"

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
    std::span<PosedBone> bones{}; ///< of all skeletons; set up
    std::span<BackboneNode> backbone_nodes{};
    InputDrawings drawings{}; ///< from outside
    InputTexts texts{};       ///< likewise
};

/// Without anything that moves. The canvas lies on the panel as `fit` wants it, and the viewer in front of
/// its middle.
SceneOnPanel on_panel(const SceneView& scene, Size panel, Fit fit);

}
