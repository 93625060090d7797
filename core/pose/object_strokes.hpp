#pragma once

#include "core/bytes/op_counter.hpp"
#include "core/bytes/picture_cache.hpp"
#include "core/features.hpp"
#include "core/math/affine.hpp"
#include "core/math/point.hpp"
#include "core/pose/posed_backbones.hpp"
#include "core/pose/posed_bones.hpp"
#include "core/pose/posed_strokes.hpp"
#include "core/pose/scene_state.hpp"
#include "core/prepared/prepared_scene.hpp"
#include "core/time/track.hpp"

#include <concepts>
#include <cstdint>
#include <optional>

namespace kfast {

class ObjectOutline;

/// The strokes of an object at one time, as its keys and skeletons make them.
class ObjectStrokes {
public:
    /// `scene` has been moved to the time, and its bones posed; both must outlive it.
    ObjectStrokes(const SceneOnPanel& scene, const Node& object);

    /// The map that places the drawing of the key before, if that is all that there is, and moves as a whole:
    /// that of a bone, or the identity. None if its points move on their own.
    std::optional<Affine> rigid_deformation() const;
    /// The drawing of the key before.
    std::uint32_t drawing() const { return from_.drawing; }
    /// Adds its strokes, as they were drawn, placed, to `outline`.
    [[gnu::cold, gnu::noinline]] void trace_drawing(const Affine& placement, ObjectOutline& outline) const;
    /// The first point of the drawing of the key before, or of the backbones that deform it.
    Point first_point() const;
    /// Adds the strokes, placed, to `outline`. Two drawings without bones, made equal, are kept in `cache` if
    /// they find room; the strokes are the same.
    void trace(PictureCache& cache, const Affine& placement, ObjectOutline& outline) const;
    /// The same without a cache; PosedStrokes::trace() says what an outline is.
    template <class Outline>
    void trace(const Affine& placement, Outline& outline) const
    {
        count_op(Op::object);
        if (is_one_drawing())
            return trace_from(placement, outline);
        if constexpr (!std::same_as<Outline, ObjectOutline>)
            trace_tween(placement, outline);
        else if (const TweenFeature* const tweens = on_panel_.scene.features().tweens)
            tweens->trace(*this, placement, outline);
    }

    /// The same for a wire frame: adds its strokes as they are seen.
    template <class Outline>
    [[gnu::cold]] void trace(const Projection& projection, Outline& outline) const
    {
        count_op(Op::object);
        PosedWires wires = posed_wires(projection);
        wires.trace(outline);
    }

    // Called for features (core/features.hpp).

    /// Traces the tween to the next key. A function of its own, because it takes much of the stack.
    template <class Outline>
    [[gnu::noinline]] void trace_tween(const Affine& placement, Outline& outline) const
    {
        PosedStrokes strokes = posed_strokes(placement);
        strokes.trace(outline);
    }
    /// The same from the cache, if both drawings find room there.
    void trace_kept_tween(PictureCache& cache, const Affine& placement, ObjectOutline& outline) const;
    /// A key drawing, deformed by a skin.
    DeformedDrawing deformed_by_bones(std::uint32_t drawing, std::int32_t skin) const;
    /// The backbones that deform the object. Their drawings are kept if there is a cache.
    const PosedBackbones& posed_backbones(PictureCache* cache) const;

private:
    /// Whether there is only one drawing to trace at the time, maybe deformed by bones.
    bool is_one_drawing() const;

    /// What a key shows.
    struct Shown {
        std::uint32_t drawing = 0; ///< offset in the section of drawings
        std::int32_t more = 0;     ///< see Key::more
    };

    /// Traces the drawing of the key before alone. A function of its own, as it takes much of the stack.
    template <class Outline>
    [[gnu::noinline]] void trace_from(const Affine& placement, Outline& outline) const
    {
        DeformedDrawing drawing = deformed(from_);
        trace_strokes(drawing, placement, outline);
    }
    PosedStrokes posed_strokes(const Affine& placement) const;
    DeformedDrawing deformed(const Shown& shown) const;
    PosedWires posed_wires(const Projection& projection) const;
    const PosedBackbones* backbones(PictureCache* cache) const;
    void read_backbones(std::uint32_t from, std::uint32_t to) const;

    const SceneOnPanel& on_panel_;
    const Node& object_;
    Shown from_;
    Shown to_; ///< at the arrival: not always what the next key shows
    ProgressXY progress_;
    mutable std::optional<PosedBackbones> backbones_; ///< made when they are first needed
};

}
