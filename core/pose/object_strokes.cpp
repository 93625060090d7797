#include "core/pose/object_strokes.hpp"

#include "core/raster/outline/object_outline.hpp"

namespace kfast {

ObjectStrokes::ObjectStrokes(const SceneOnPanel& scene, const Node& object)
    : on_panel_{scene}, object_{object}
{
    const PreparedScene& prepared = scene.prepared;
    const TrackState& drawing = prepared.key_track(object, KeyValue::drawing);
    from_.drawing = static_cast<std::uint32_t>(drawing.from);
    to_.drawing = static_cast<std::uint32_t>(prepared.arrival(object));
    progress_ = prepared.progress(drawing);
    if (!object.has_more())
        return;
    const TrackState& more = prepared.key_track(object, KeyValue::more);
    from_.more = more.from;
    to_.more = more.to;
}

std::optional<Affine> ObjectStrokes::rigid_deformation() const
{
    if (!on_panel_.prepared.has_one_drawing(object_) || object_.deformer == Deformer::backbones)
        return std::nullopt;
    if (object_.deformer == Deformer::none)
        return Affine{};
    if (from_.more >= 0) // a skin, of several bones
        return std::nullopt;
    return on_panel_.bones[object_.of + SceneView::bone_of(from_.more)].map();
}

Point ObjectStrokes::first_point() const
{
    PackedDrawing drawing = on_panel_.scene.drawing(from_.drawing);
    if (object_.deformer == Deformer::backbones)
        drawing = on_panel_.scene.drawing(
            item_view(on_panel_.scene, object_).object.backbones.keys().next().drawing);
    if (drawing.strokes() != 0)
        drawing.next_stroke();
    return drawing.start();
}

void ObjectStrokes::trace_drawing(const Affine& placement, ObjectOutline& outline) const
{
    count_op(Op::object);
    DeformedDrawing drawing{on_panel_.scene.drawing(from_.drawing)};
    trace_strokes(drawing, placement, outline);
}

bool ObjectStrokes::is_one_drawing() const
{
    return object_.deformer != Deformer::backbones &&
           (progress_.is_at_beginning() || on_panel_.prepared.has_one_drawing(object_));
}

void ObjectStrokes::trace(PictureCache& cache, const Affine& placement, ObjectOutline& outline) const
{
    const TweenFeature* const tweens = on_panel_.scene.features().tweens;
    if (object_.deformer == Deformer::bones || tweens == nullptr)
        trace(placement, outline);
    else
        tweens->trace_kept(*this, cache, placement, outline);
}

void ObjectStrokes::trace_kept_tween(PictureCache& cache, const Affine& placement,
                                     ObjectOutline& outline) const
{
    const PosedBackbones* const deformers = backbones(&cache); // first, for it may write to the cache
    const bool is_held =
        on_panel_.prepared.is_held(on_panel_.scene, on_panel_.prepared.key_track(object_, KeyValue::drawing));
    const std::uint32_t to = is_held ? from_.drawing : to_.drawing;
    const auto tween = kept_tween(cache, on_panel_.scene.drawings(), from_.drawing, to);
    if (!tween || (progress_.is_at_beginning() && !tween->is_plain()))
        return trace(placement, outline);
    count_op(Op::object);
    trace_kept(*tween, progress_, deformers, placement, outline);
}

/// A function of its own, so that what they are made of is on the stack only while they are made.
[[gnu::noinline]] PosedStrokes ObjectStrokes::posed_strokes(const Affine& placement) const
{
    const SceneView& scene = on_panel_.scene;
    return {{scene.drawing(from_.drawing).strokes(), scene.drawing(to_.drawing).strokes()},
            [this](bool is_second) { return deformed(is_second ? to_ : from_); },
            progress_,
            backbones(nullptr),
            placement};
}

[[gnu::noinline]] PosedWires ObjectStrokes::posed_wires(const Projection& projection) const
{
    const auto wires = [](const Shown& shown) {
        return WireDrawing{shown.drawing, static_cast<std::uint32_t>(shown.more)};
    };
    return {on_panel_.scene.drawings(), wires(from_), wires(to_), progress_, projection};
}

DeformedDrawing ObjectStrokes::deformed(const Shown& shown) const
{
    if (object_.deformer != Deformer::bones)
        return DeformedDrawing{on_panel_.scene.drawing(shown.drawing)};
    return on_panel_.scene.features().bones->deformed(*this, shown.drawing, shown.more);
}

DeformedDrawing ObjectStrokes::deformed_by_bones(std::uint32_t drawing, std::int32_t skin) const
{
    const SceneView& scene = on_panel_.scene;
    const PackedDrawing own = scene.drawing(drawing);
    const SkinReader reader = scene.skin(skin);
    return {own, reader.has_drawing_at_rest() ? scene.drawing(reader.drawing_at_rest()) : own, reader,
            on_panel_.bones.subspan(object_.of)};
}

/// Null if none deform the object.
const PosedBackbones* ObjectStrokes::backbones(PictureCache* cache) const
{
    if (object_.deformer != Deformer::backbones)
        return nullptr;
    return &on_panel_.scene.features().backbones->live(*this, cache);
}

const PosedBackbones& ObjectStrokes::posed_backbones(PictureCache* cache) const
{
    if (backbones_)
        return *backbones_;
    const TrackState& keys = on_panel_.prepared.key_track(object_, KeyValue::backbones);
    const auto from = static_cast<std::uint32_t>(keys.from);
    const auto to = static_cast<std::uint32_t>(keys.to);
    const auto both =
        cache != nullptr ? kept_tween(*cache, on_panel_.scene.drawings(), from, to) : std::nullopt;
    if (both)
        backbones_.emplace(on_panel_.backbone_nodes, object_.unit_bits, *both,
                           on_panel_.prepared.progress(keys));
    else
        read_backbones(from, to);
    return *backbones_;
}

/// A function of its own, so that the readers are on the stack only where they are needed.
[[gnu::noinline]] void ObjectStrokes::read_backbones(std::uint32_t from, std::uint32_t to) const
{
    const TrackState& keys = on_panel_.prepared.key_track(object_, KeyValue::backbones);
    backbones_.emplace(on_panel_.backbone_nodes, object_.unit_bits, on_panel_.scene.drawing(from),
                       on_panel_.scene.drawing(to), on_panel_.prepared.progress(keys));
}

}
