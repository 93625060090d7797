#pragma once

#include "core/math/point.hpp"
#include "core/raster/outline/picture.hpp"
#include "core/scene/scene_view.hpp"

#include <cstddef>
#include <cstdint>
#include <string>

namespace kfast {

/// What of a picture found room for its outlines, the least first.
enum class Detail : std::uint8_t {
    parts_missing,
    coarse, ///< all of it, its curves in fewer pieces
    full,
};

Detail detail_of(const raster::Picture& picture);

/// How many of a scene's pictures on a panel are drawn with less than full detail, with inputs at their
/// defaults.
struct CoarsePictures {
    std::size_t coarse = 0;
    std::size_t looked_at = 0; ///< all frames of one turn, or some of them, evenly spread
};

/// Looks at no more than `max_pictures` of them.
CoarsePictures coarse_pictures(const SceneView& scene, Size panel, std::size_t max_pictures);

/// The detail of the pictures that a source shows.
class ShownDetail {
public:
    void add(const raster::Picture& picture);

    Detail min() const { return min_; }
    /// Of the last picture, in words for FrameSource::facts(); empty if it is full.
    std::string text() const;

private:
    Detail last_ = Detail::full;
    Detail min_ = Detail::full;
};

}
