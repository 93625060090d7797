#pragma once

#include "core/math/point.hpp"
#include "host/preview/overlay/posed_scene.hpp"

#include <vector>

namespace kfast {

/// A stroke as the player tweens it at a time, after it was matched with its partner: on the panel, in
/// perspective if there is some.
struct SeenStroke {
    /// From a point to a control point of the curve that begins or ends there.
    struct Control {
        Point from;
        Point to;
    };

    std::vector<Point> points;     ///< ends of segments; of a closed stroke the first is not repeated
    std::vector<Control> controls; ///< two for each curve
    std::vector<Point> line;       ///< straight pieces through these points
    bool is_closed = false;
};

/// The strokes of a leaf, in its order. `scene` visits the leaf just now.
std::vector<SeenStroke> seen_strokes(const PosedScene& scene, const SeenLeaf& leaf);

/// The same, but at a key of an object, where it is seen as it was drawn, they are those of the tween that
/// begins there, at the last key those of the tween that ends there: the same number is the same point in
/// both keys. They are within 1/65536 of the tween from where they are seen.
std::vector<SeenStroke> matched_strokes(const PosedScene& scene, const SeenLeaf& leaf);

}
