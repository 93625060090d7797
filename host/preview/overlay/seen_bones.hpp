#pragma once

#include "core/math/point.hpp"
#include "host/preview/overlay/posed_scene.hpp"

#include <vector>

namespace kfast {

/// A bone where it is seen, on the panel.
struct SeenBone {
    Point origin;
    Point tip;
};

/// The bones of a skeleton, the way they are posed, seen through `space`. `skeleton` is its number in the
/// scene, which was visited.
std::vector<SeenBone> seen_bones(const PosedScene& scene, std::uint32_t skeleton, const Space& space);

/// A backbone and its outline where they are seen, on the panel: as many points of each, node by node.
struct SeenBackbone {
    std::vector<Point> nodes;
    std::vector<Point> left;
    std::vector<Point> right;
};

/// The backbones that carry an object at this moment; none if none do. `scene` visits the leaf just now.
std::vector<SeenBackbone> seen_backbones(const PosedScene& scene, const SeenLeaf& leaf);

}
