#include "host/preview/overlay/seen_strokes.hpp"

#include "core/features.hpp"
#include "core/math/flatten.hpp"
#include "core/math/projection.hpp"
#include "core/pose/input_drawing.hpp"
#include "core/pose/label_layout.hpp"
#include "core/pose/object_strokes.hpp"
#include "core/pose/posed_strokes.hpp"

#include <optional>
#include <utility>

namespace kfast {
namespace {

/// Keeps the traced strokes, as they are seen.
class StrokeList {
public:
    explicit StrokeList(const Projection* projection) : view_{projection, 0} {}

    void begin(Point from)
    {
        strokes_.emplace_back();
        stroke().points.push_back(view_(from));
        stroke().line.push_back(view_(from));
    }

    void add(const Segment& segment)
    {
        const Point to = view_(segment.to);
        if (segment.kind == Segment::Kind::cubic) {
            stroke().controls.push_back({view_(segment.from), view_(segment.c1)});
            stroke().controls.push_back({to, view_(segment.c2)});
        }
        stroke().points.push_back(to);
        flatten(segment, view_.pieces_of(segment), [this](Point at) { stroke().line.push_back(view_(at)); });
    }

    void end(Point /*hub*/, bool is_closed)
    {
        stroke().is_closed = is_closed;
        if (is_closed && stroke().points.size() > 1)
            stroke().points.pop_back();
    }

    std::vector<SeenStroke> take() { return std::move(strokes_); }

private:
    SeenStroke& stroke() { return strokes_.back(); }

    ViewProjection view_;
    std::vector<SeenStroke> strokes_;
};

/// The tween at which an object is at one of its keys, if there is one.
struct KeyTween {
    Key from;
    std::uint32_t arrival = 0;
    Key to;
    ProgressXY progress; ///< at one of its ends, but not so that only one of the keys counts
};

std::optional<KeyTween> tween_at_key(const ObjectView& object, Time time)
{
    constexpr Progress hardly{1};
    constexpr Progress almost{Progress::one - 1};
    std::optional<KeyTween> before;
    KeyCursor keys = object.keys();
    Key from = keys.next();
    while (!keys.at_end()) {
        const Key to = keys.next();
        const std::uint32_t arrival = object.has_arrivals ? from.arrival : to.drawing;
        if (time < to.time)
            return KeyTween{from, arrival, to, {hardly, hardly}};
        before = KeyTween{from, arrival, to, {almost, almost}};
        from = to;
    }
    return before;
}

/// The strokes of an object between one drawing and another, in pairs also where it is at a key.
class MatchedObject {
public:
    MatchedObject(const SceneOnPanel& on_panel, const SeenLeaf& leaf, const KeyTween& tween)
        : on_panel_{on_panel}, object_{leaf.item.object}, moment_{leaf.moment}, tween_{tween}
    {
    }

    void trace(const Affine& placement, StrokeList& strokes) const
    {
        std::optional<PosedBackbones> backbones;
        if (object_.deformer == Deformer::backbones)
            backbones = posed_backbones();
        const auto drawing = [this](bool is_second) {
            return is_second ? deformed(tween_.arrival, tween_.to.more)
                             : deformed(tween_.from.drawing, tween_.from.more);
        };
        const SceneView& scene = on_panel_.scene;
        PosedStrokes{{scene.drawing(tween_.from.drawing).strokes(), scene.drawing(tween_.arrival).strokes()},
                     drawing,
                     tween_.progress,
                     backbones ? &*backbones : nullptr,
                     placement}
            .trace(strokes);
    }

    void trace(const Projection& projection, StrokeList& strokes) const
    {
        const auto wires = [](const Key& key) {
            return WireDrawing{key.drawing, static_cast<std::uint32_t>(key.more)};
        };
        PosedWires{on_panel_.scene.drawings(), wires(tween_.from), wires(tween_.to), tween_.progress,
                   projection}
            .trace(strokes);
    }

private:
    DeformedDrawing deformed(std::uint32_t drawing, std::int32_t skin) const
    {
        const SceneView& scene = on_panel_.scene;
        const PackedDrawing own = scene.drawing(drawing);
        if (object_.deformer != Deformer::bones)
            return DeformedDrawing{own};
        const SkinReader reader = scene.skin(skin);
        return {own, reader.has_drawing_at_rest() ? scene.drawing(reader.drawing_at_rest()) : own, reader,
                on_panel_.bones.subspan(scene.first_bone(object_.skeleton))};
    }

    PosedBackbones posed_backbones() const
    {
        const SceneView& scene = on_panel_.scene;
        const BackboneKeyCursor keys = object_.backbones.keys();
        const Time time = moment_.at(keys.key_times().driver());
        const auto [from, to] = interval_at(keys, time);
        return {on_panel_.backbone_nodes, object_.backbones.unit_bits, scene.drawing(from.drawing),
                scene.drawing(to.drawing),
                progress_between(from.time, to.time, time, scene.laws(from.laws), &kfast_springs)};
    }

    const SceneOnPanel& on_panel_;
    const ObjectView& object_;
    const SceneTime& moment_;
    const KeyTween& tween_;
};

/// Whether it is seen as one of its keys has it.
bool stands_at_key(const SceneView& scene, const ObjectView& object, const SceneTime& moment)
{
    const KeyCursor keys = object.keys();
    const Time time = moment.at(keys.key_times().driver());
    const auto [from, to] = interval_at(keys, time);
    return progress_between(from.time, to.time, time, scene.laws(from.laws), &kfast_springs)
        .is_at_beginning();
}

void trace_live(const SceneOnPanel& on_panel, const LiveView& live, const Affine& placement,
                StrokeList& strokes)
{
    const SceneView& scene = on_panel.scene;
    switch (live.kind) {
    case InputLeaf::drawing:
        return trace_live_strokes(on_panel.drawings.of(scene, live.input), placement, strokes);
    case InputLeaf::label:
        return label_of(on_panel, live).trace(placement, strokes);
    }
}

/// What traces an object also does so with a placement, or in perspective.
template <class TracedObject>
std::vector<SeenStroke> strokes_of(const SceneOnPanel& on_panel, const SeenLeaf& leaf,
                                   const TracedObject& object)
{
    const Projection projection{leaf.space, on_panel.camera};
    if (leaf.item.object.has_depths) { // points are projected already
        StrokeList strokes{nullptr};
        object.trace(projection, strokes);
        return strokes.take();
    }
    const bool is_flat = leaf.space.is_flat();
    StrokeList strokes{is_flat ? nullptr : &projection};
    object.trace(is_flat ? leaf.space.plane : Affine{}, strokes);
    return strokes.take();
}

std::vector<SeenStroke> posed_strokes(const SceneOnPanel& on_panel, const SeenLeaf& leaf)
{
    const Projection projection{leaf.space, on_panel.camera};
    const bool is_flat = leaf.space.is_flat();
    StrokeList strokes{is_flat ? nullptr : &projection};
    trace_live(on_panel, leaf.item.live, is_flat ? leaf.space.plane : Affine{}, strokes);
    return strokes.take();
}

}

std::vector<SeenStroke> seen_strokes(const PosedScene& scene, const SeenLeaf& leaf)
{
    const SceneOnPanel& on_panel = scene.on_panel();
    if (leaf.item.kind != ItemKind::object)
        return posed_strokes(on_panel, leaf);
    return strokes_of(on_panel, leaf, ObjectStrokes{on_panel, leaf.node});
}

std::vector<SeenStroke> matched_strokes(const PosedScene& scene, const SeenLeaf& leaf)
{
    const SceneOnPanel& on_panel = scene.on_panel();
    const ObjectView& object = leaf.item.object;
    if (leaf.item.kind != ItemKind::object || !stands_at_key(on_panel.scene, object, leaf.moment))
        return seen_strokes(scene, leaf);
    const auto tween = tween_at_key(object, leaf.moment.at(object.keys().key_times().driver()));
    return tween ? strokes_of(on_panel, leaf, MatchedObject{on_panel, leaf, *tween})
                 : seen_strokes(scene, leaf);
}

}
