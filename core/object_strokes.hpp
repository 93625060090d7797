#pragma once

#include "core/affine.hpp"
#include "core/carried_drawing.hpp"
#include "core/item_view.hpp"
#include "core/key_interval.hpp"
#include "core/live_backbones.hpp"
#include "core/live_strokes.hpp"
#include "core/live_wires.hpp"
#include "core/moment.hpp"
#include "core/picture_cache.hpp"
#include "core/point.hpp"
#include "core/scene_on_panel.hpp"
#include "core/still.hpp"
#include "core/work.hpp"

#include <cstdint>
#include <optional>

namespace kfast {

class ObjectOutline;

/// What an object's keys and skeletons make of its drawing at one moment.
class ObjectStrokes {
public:
    /// All must outlive it.
    ObjectStrokes(const SceneOnPanel& scene, const ObjectView& object, const Moment& moment);

    /// How long it stays as it is, its skeletons included.
    Still still() const;
    /// What places the drawing of the key before, if that is all that there is, and moves as a whole: a bone,
    /// or nothing. None if its points move on their own.
    std::optional<Affine> rigid_carrier() const;
    /// The drawing of the key before.
    std::uint32_t drawing() const { return keys_.from.drawing; }
    /// Adds its strokes, as they were drawn, likewise.
    [[gnu::cold, gnu::noinline]] void trace_drawing(const Affine& placement, ObjectOutline& outline) const;
    /// Of the drawing of the key before, or of the backbones that carry it.
    Point first_point() const;
    /// Adds the strokes, placed, to `outline`. What drawings without bones come to between two keys is kept
    /// in `cache` if it finds room; the strokes are the same.
    void trace(PictureCache& cache, const Affine& placement, ObjectOutline& outline) const;
    /// The same without a cache; LiveStrokes::trace() says what an outline is.
    template <class Outline>
    void trace(const Affine& placement, Outline& outline) const
    {
        did(Work::object);
        const Progress way = progress();
        const CarriedDrawing begin = carried(keys_.from.drawing, keys_.from.more);
        const CarriedDrawing end = way.is_at_beginning() ? begin : carried(arrival(), keys_.to.more);
        LiveStrokes{begin, end, way, live_backbones(nullptr), placement}.trace(outline);
    }

    /// Likewise of a wire frame: what is seen of its strokes.
    template <class Outline>
    [[gnu::cold]] void trace(const Projection& projection, Outline& outline) const
    {
        did(Work::object);
        LiveWires{wires(keys_.from), wires(keys_.to), progress(), projection}.trace(outline);
    }

private:
    /// On the whole way from key to key.
    bool has_one_drawing() const;
    bool is_held() const;
    Progress progress() const;
    std::uint32_t arrival() const { return object_.has_arrivals ? keys_.from.arrival : keys_.to.drawing; }
    CarriedDrawing carried(std::uint32_t drawing, std::int32_t skin) const;
    WireDrawing wires(const Key& key) const;
    const LiveBackbones* live_backbones(PictureCache* cache) const;

    const SceneOnPanel& on_panel_;
    const ObjectView& object_;
    const Moment& moment_;
    Clock clock_;
    Time time_; ///< of the clock that the keys go by
    KeyInterval<Key> keys_;
    mutable std::optional<LiveBackbones> backbones_; ///< made when they are first wanted
};

}
