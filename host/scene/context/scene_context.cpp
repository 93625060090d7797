#include "host/scene/context/scene_context.hpp"

#include "host/scene/context/limits.hpp"

#include <string>

namespace kfast::scene {

bool take_points(std::size_t points, SourceSpan place, SceneContext& context)
{
    return context.points.take(points) ||
           context.report.error(place, "the drawings of a scene hold at most " +
                                           std::to_string(max_points_of_scene) + " points");
}

}
