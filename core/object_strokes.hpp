#pragma once

#include "core/affine.hpp"
#include "core/carried_drawing.hpp"
#include "core/evaluator/node.hpp"
#include "core/key_interval.hpp"
#include "core/live_backbones.hpp"
#include "core/live_strokes.hpp"
#include "core/live_wires.hpp"
#include "core/picture_cache.hpp"
#include "core/point.hpp"
#include "core/scene_on_panel.hpp"
#include "core/work.hpp"

#include <cstdint>
#include <optional>

namespace kfast {

class ObjectOutline;

/// What an object's keys and skeletons make of its drawing at one moment.
class ObjectStrokes {
public:
    /// `scene` has been moved to the moment, and its bones posed; both must outlive it.
    ObjectStrokes(const SceneOnPanel& scene, const Node& object);

    /// What places the drawing of the key before, if that is all that there is, and moves as a whole: a bone,
    /// or nothing. None if its points move on their own.
    std::optional<Affine> rigid_carrier() const;
    /// The drawing of the key before.
    std::uint32_t drawing() const { return from_.drawing; }
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
        if (way_.is_at_beginning() && object_.carrier != Carrier::backbones)
            trace_strokes(carried(from_), placement, outline);
        else
            trace_way(placement, outline);
    }

    /// Likewise of a wire frame: what is seen of its strokes.
    template <class Outline>
    [[gnu::cold]] void trace(const Projection& projection, Outline& outline) const
    {
        did(Work::object);
        LiveWires{wires(from_), wires(to_), way_, projection}.trace(outline);
    }

private:
    /// What a key shows.
    struct Shown {
        std::uint32_t drawing = 0; ///< offset in the section of drawings
        std::int32_t more = 0;     ///< see Key::more
    };

    /// On the way to the next key. Apart, for it takes much of the stack.
    template <class Outline>
    [[gnu::noinline]] void trace_way(const Affine& placement, Outline& outline) const
    {
        LiveStrokes{carried(from_), carried(to_), way_, live_backbones(nullptr), placement}.trace(outline);
    }
    CarriedDrawing carried(const Shown& shown) const;
    WireDrawing wires(const Shown& shown) const;
    const LiveBackbones* live_backbones(PictureCache* cache) const;

    const SceneOnPanel& on_panel_;
    const Node& object_;
    Shown from_;
    Shown to_; ///< to which the way leads: not always what the next key shows
    Progress way_;
    mutable std::optional<LiveBackbones> backbones_; ///< made when they are first wanted
};

}
