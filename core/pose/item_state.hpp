#pragma once

#include "core/math/fixed.hpp"
#include "core/math/point.hpp"
#include "core/math/space.hpp"
#include "core/pixel/colour.hpp"
#include "core/prepared/node.hpp"
#include "core/prepared/prepared_scene.hpp"
#include "core/scene/scene_view.hpp"

#include <cstdint>

namespace kfast {

/// What the tracks of an item come to at the moment of a prepared scene.
class ItemState {
public:
    /// All must outlive it.
    ItemState(const SceneView& scene, const PreparedScene& prepared, const Node& item)
        : scene_{scene}, prepared_{prepared}, item_{item}
    {
    }

    /// 0 … 255; 0 if the item is not to be seen at all.
    std::uint32_t opacity() const;
    /// From the item's own space to that of what it lies in.
    Space placement() const;
    Point pivot() const;
    /// Only of what is filled.
    Colour fill() const { return colour(Property::fill, item_.style.fill); }
    /// Only of what is stroked.
    Colour stroke() const { return colour(Property::stroke, item_.style.stroke); }
    /// Of the stroke; likewise.
    Fixed width() const;

private:
    const TrackState* track(Property property) const;
    std::int32_t fine(Property property) const;
    Colour colour(Property property, std::uint8_t without_track) const;

    const SceneView& scene_;
    const PreparedScene& prepared_;
    const Node& item_;
};

}
