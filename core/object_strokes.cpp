#include "core/object_strokes.hpp"

#include "core/object_outline.hpp"

namespace kfast {

ObjectStrokes::ObjectStrokes(const SceneOnPanel& scene, const ObjectView& object, const Moment& moment)
    : on_panel_{scene}, object_{object}, moment_{moment}
{
    const KeyCursor keys = object.keys();
    clock_ = keys.beats().clock();
    time_ = moment.at(clock_);
    keys_ = interval_at(keys, time_);
}

bool ObjectStrokes::has_one_drawing() const
{
    return keys_.from.drawing == arrival() && keys_.from.more == keys_.to.more;
}

std::optional<Affine> ObjectStrokes::rigid_carrier() const
{
    if (!has_one_drawing() || object_.carrier == Carrier::backbones)
        return std::nullopt;
    if (object_.carrier == Carrier::none)
        return Affine{};
    if (keys_.from.more >= 0) // a skin, of several bones
        return std::nullopt;
    const std::size_t first = on_panel_.scene.first_bone(object_.skeleton);
    return on_panel_.bones[first + SceneView::bone_of(keys_.from.more)].map();
}

Still ObjectStrokes::still() const
{
    if (object_.carrier != Carrier::none)
        return moving_with_any_input(moment_.time());
    const Time begin = keys_.from.time;
    const Time end = keys_.to.time;
    const Still between = has_one_drawing()
                              ? Still{.begin = begin, .end = end}
                              : still_between(begin, end, time_, on_panel_.scene.laws(keys_.from.laws));
    return still_by_clock(clock_, still_around(keys_, time_, between));
}

Point ObjectStrokes::first_point() const
{
    const bool has_backbones = object_.carrier == Carrier::backbones;
    PackedDrawing drawing =
        on_panel_.scene.drawing(has_backbones ? object_.backbones.keys().next().drawing : keys_.from.drawing);
    if (drawing.strokes() != 0)
        drawing.next_stroke();
    return drawing.start();
}

void ObjectStrokes::trace_drawing(const Affine& placement, ObjectOutline& outline) const
{
    did(Work::object);
    const CarriedDrawing drawing{on_panel_.scene.drawing(keys_.from.drawing)};
    LiveStrokes{drawing, drawing, {}, nullptr, placement}.trace(outline);
}

void ObjectStrokes::trace(PictureCache& cache, const Affine& placement, ObjectOutline& outline) const
{
    if (object_.carrier == Carrier::bones)
        return trace(placement, outline);
    const LiveBackbones* const backbones = live_backbones(&cache); // first, for it may write to the cache
    const std::uint32_t to = is_held() ? keys_.from.drawing : arrival();
    const auto tween = kept_tween(cache, on_panel_.scene.drawings(), keys_.from.drawing, to);
    const Progress way = progress();
    if (!tween || (way.is_at_beginning() && !tween->is_plain()))
        return trace(placement, outline);
    did(Work::object);
    trace_kept(*tween, way, backbones, placement, outline);
}

/// The drawing of the key before stays until the next key.
bool ObjectStrokes::is_held() const
{
    const LawPair laws = on_panel_.scene.laws(keys_.from.laws);
    return laws.x == VelocityLaw::hold && laws.y == VelocityLaw::hold;
}

Progress ObjectStrokes::progress() const
{
    return progress_between(keys_.from.time, keys_.to.time, time_, on_panel_.scene.laws(keys_.from.laws));
}

CarriedDrawing ObjectStrokes::carried(std::uint32_t drawing, std::int32_t skin) const
{
    const SceneView& scene = on_panel_.scene;
    const PackedDrawing own = scene.drawing(drawing);
    if (object_.carrier != Carrier::bones)
        return CarriedDrawing{own};
    const SkinReader reader = scene.skin(skin);
    return {own, reader.has_drawing_at_rest() ? scene.drawing(reader.drawing_at_rest()) : own, reader,
            on_panel_.bones.subspan(scene.first_bone(object_.skeleton))};
}

WireDrawing ObjectStrokes::wires(const Key& key) const
{
    return {on_panel_.scene.drawing(key.drawing),
            on_panel_.scene.drawing(static_cast<std::uint32_t>(key.more))};
}

/// Null if none carry the object. Their drawings are kept if there is a cache.
const LiveBackbones* ObjectStrokes::live_backbones(PictureCache* cache) const
{
    if (object_.carrier != Carrier::backbones || backbones_)
        return backbones_ ? &*backbones_ : nullptr;
    const SceneView& scene = on_panel_.scene;
    const BackboneKeyCursor keys = object_.backbones.keys();
    const Time time = moment_.at(keys.beats().clock());
    const auto [from, to] = interval_at(keys, time);
    const Progress way = progress_between(from.time, to.time, time, scene.laws(from.laws));
    const std::span<BackboneNode> nodes = on_panel_.backbone_nodes;
    const std::uint32_t unit_bits = object_.backbones.unit_bits;
    const auto both =
        cache != nullptr ? kept_tween(*cache, scene.drawings(), from.drawing, to.drawing) : std::nullopt;
    if (both)
        backbones_.emplace(nodes, unit_bits, *both, way);
    else
        backbones_.emplace(nodes, unit_bits, scene.drawing(from.drawing), scene.drawing(to.drawing), way);
    return &*backbones_;
}

}
