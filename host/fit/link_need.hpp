#pragma once

#include "core/scene/scene_view.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace kfast::fit {

/// Reports of 64 bytes that a device takes by USB at most (docs/design.md, "USB").
inline constexpr double reports_per_second = 1000;

/// What telling inputs of a scene takes on the link (docs/link.md).
struct LinkUpdate {
    std::string what;        ///< "13 numbers", "plot, 200 points in 1 stroke"
    std::size_t reports = 0; ///< for all of it

    double max_per_second() const { return reports_per_second / static_cast<double>(reports); }
};

/// All numbers at once, if the scene has some, and each drawing with all of its points.
std::vector<LinkUpdate> link_need(const SceneView& scene);

}
