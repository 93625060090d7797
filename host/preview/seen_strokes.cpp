#include "host/preview/seen_strokes.hpp"

#include "core/flatten.hpp"
#include "core/label_trace.hpp"
#include "core/live_drawing_trace.hpp"
#include "core/object_strokes.hpp"
#include "core/sight.hpp"

#include <utility>

namespace kfast {
namespace {

/// Keeps what is traced, as it is seen.
class StrokeList {
public:
    explicit StrokeList(const Projection* projection) : sight_{projection, 0} {}

    void begin(Point from)
    {
        strokes_.emplace_back();
        stroke().points.push_back(sight_(from));
        stroke().line.push_back(sight_(from));
    }

    void add(const Segment& segment)
    {
        const Point to = sight_(segment.to);
        if (segment.kind == Segment::Kind::cubic) {
            stroke().controls.push_back({sight_(segment.from), sight_(segment.c1)});
            stroke().controls.push_back({to, sight_(segment.c2)});
        }
        stroke().points.push_back(to);
        flatten(segment, sight_.pieces_of(segment),
                [this](Point at) { stroke().line.push_back(sight_(at)); });
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

    Sight sight_;
    std::vector<SeenStroke> strokes_;
};

void trace_live(const SceneOnPanel& on_panel, const LiveView& live, const Affine& placement,
                StrokeList& strokes)
{
    const SceneView& scene = on_panel.scene;
    switch (live.kind) {
    case LiveKind::drawing:
        return trace_live_strokes(on_panel.drawings.of(scene, live.input), placement, strokes);
    case LiveKind::label:
        return LabelTrace{LabelView::of(live.label), on_panel.texts.glyphs(scene, live.input),
                          scene.drawings()}
            .trace(placement, strokes);
    }
}

}

std::vector<SeenStroke> seen_strokes(const PosedScene& scene, const SeenLeaf& leaf)
{
    const SceneOnPanel& on_panel = scene.on_panel();
    const Projection projection{leaf.space, on_panel.camera};
    const ObjectView& object = leaf.item.object;
    const bool is_object = leaf.item.kind == ItemKind::object;
    if (is_object && object.has_depths) { // points come as they are seen
        StrokeList strokes{nullptr};
        ObjectStrokes{on_panel, object, leaf.moment}.trace(projection, strokes);
        return strokes.take();
    }
    const bool is_flat = leaf.space.is_flat();
    const Affine placement = is_flat ? leaf.space.plane : Affine{};
    StrokeList strokes{is_flat ? nullptr : &projection};
    if (is_object)
        ObjectStrokes{on_panel, object, leaf.moment}.trace(placement, strokes);
    else
        trace_live(on_panel, leaf.item.live, placement, strokes);
    return strokes.take();
}

}
