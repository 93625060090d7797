#include "core/pose/scene_on_panel.hpp"

namespace kfast {
namespace {

Space canvas_space(Size canvas, Size panel, Fit fit)
{
    const Affine map = canvas_map(canvas, panel, fit);
    return {.plane = map, .zz = map.xx};
}

Camera camera_for(const SceneView& scene, Size panel, const Space& canvas)
{
    return {.x = std::int64_t{panel.width} * Fixed::one / 2,
            .y = std::int64_t{panel.height} * Fixed::one / 2,
            .distance = std::int64_t{scene.camera()} * canvas.zz};
}

}

SceneOnPanel on_panel(const SceneView& scene, Size panel, Fit fit)
{
    const Space canvas = canvas_space(scene.canvas(), panel, fit);
    return {.scene = scene,
            .canvas = canvas,
            .camera = camera_for(scene, panel, canvas),
            .rigid = RigidPlacements{canvas.plane.xx}};
}

}
