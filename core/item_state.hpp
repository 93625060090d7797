#pragma once

#include "core/angle.hpp"
#include "core/colour.hpp"
#include "core/item_view.hpp"
#include "core/moment.hpp"
#include "core/passage.hpp"
#include "core/scene_view.hpp"
#include "core/space.hpp"
#include "core/still.hpp"
#include "core/time.hpp"

#include <array>
#include <cstdint>

namespace kfast {

/// What the tracks of an item come to at one moment.
class ItemState {
public:
    ItemState(const SceneView& scene, const ItemView& item, const Moment& moment);

    /// How long all of it stays as it is.
    const Still& still() const { return still_; }
    /// 0 … 255; 0 if the item is not to be seen at all.
    std::uint32_t opacity() const;
    /// From the item's own space to that of what it lies in.
    Space placement() const;
    Point pivot() const { return {pixels(Property::pivot_x), pixels(Property::pivot_y)}; }
    /// Only of what is filled.
    Colour fill() const { return fill_; }
    /// Only of what is stroked.
    Colour stroke() const { return stroke_; }
    /// Of the stroke; likewise.
    Fixed width() const;

private:
    void read(const SceneView& scene, const TrackView& track, const Moment& moment);
    void take(const SceneView& scene, Property property, const Passage& passage);
    std::int32_t fine(Property property) const { return fine_[static_cast<std::size_t>(property)]; }
    std::int32_t whole(Property property) const;
    Fixed pixels(Property property) const;
    FineAngle angle(Property property) const { return FineAngle::of_fine(fine(property)); }
    void follow(const PathView& path, const PackedDrawing& stroke);
    Space turning() const;

    std::array<std::int32_t, property_count> fine_; ///< in 1/256 of the unit of the property
    Point position_;                                ///< that a path gives it
    FineAngle turned_;                              ///< by a path
    Colour fill_;
    Colour stroke_;
    Still still_;
};

/// The place of an item among those beside it: Property::order at `moment`.
std::int32_t order_at(const ItemView& item, const Moment& moment);

}
