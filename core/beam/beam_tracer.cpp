#include "core/beam/beam_tracer.hpp"

#include "core/beam/beam_pen.hpp"
#include "core/beam/hatching.hpp"
#include "core/math/projection.hpp"
#include "core/math/stroke_trimmer.hpp"
#include "core/pixel/paint_style.hpp"
#include "core/pose/input_drawing.hpp"
#include "core/pose/label_layout.hpp"

namespace kfast {
namespace {

/// The colour over the dark of the display.
Colour shining(Colour colour, std::uint32_t opacity)
{
    const std::uint32_t share = product_of_opacities(colour.opacity, opacity);
    const auto dimmed = [share](std::uint8_t channel) {
        return static_cast<std::uint8_t>(product_of_opacities(channel, share));
    };
    return {dimmed(colour.red), dimmed(colour.green), dimmed(colour.blue), 255};
}

}

void BeamTracer::run()
{
    coarseness_ = 0;
    trace_scene();
    while (lines_.is_full() && coarseness_ < coarsest) {
        ++coarseness_;
        trace_scene();
    }
}

void BeamTracer::trace_scene()
{
    lines_.clear();
    wider_hatchings_ = 0;
    SceneWalk walk{on_panel_, SceneWalk::Opacity::of_leaves};
    while (walk.next() == SceneWalk::Step::leaf)
        trace_leaf(walk);
    dependence_ = walk.whole();
}

void BeamTracer::trace_leaf(SceneWalk& walk)
{
    const ItemView item = item_view(on_panel_.scene, walk.node());
    if (item.kind == ItemKind::object)
        trace_object(walk, item.beam);
    else
        trace_live(walk, item);
}

void BeamTracer::trace_object(SceneWalk& walk, const BeamStyle& beam)
{
    const ObjectStrokes strokes{on_panel_, walk.node()};
    if (walk.node().has_depths) {
        if (beam.has_outline())
            trace_wires(walk, strokes);
        return;
    }
    add_lines(walk, beam, [&](const Affine& placement, auto& pen) { strokes.trace(placement, pen); });
}

/// Points are projected already.
void BeamTracer::trace_wires(SceneWalk& walk, const ObjectStrokes& strokes)
{
    const Colour colour = shining(walk.state().stroke(), walk.leaf_opacity());
    if (brightness(colour) == 0)
        return;
    const Projection projection{walk.space(), on_panel_.camera};
    BeamPen pen{lines_,     ViewProjection{nullptr, coarseness_}, resolution_, BeamInk::stroke, colour,
                walk.path()};
    strokes.trace(projection, pen);
}

void BeamTracer::trace_live(SceneWalk& walk, const ItemView& item)
{
    const SceneView& scene = on_panel_.scene;
    add_lines(walk, item.beam, [&](const Affine& placement, auto& pen) {
        switch (item.live.kind) {
        case InputLeaf::drawing:
            return trace_live_strokes(on_panel_.drawings.of(scene, item.live.input), placement, pen);
        case InputLeaf::label:
            return label_of(on_panel_, item.live).trace(placement, pen);
        }
    });
}

/// trace(placement, pen) draws the strokes with a pen.
template <class Trace>
void BeamTracer::add_lines(SceneWalk& walk, const BeamStyle& beam, Trace trace)
{
    const Trim trim = walk.node().is_cut ? walk.state().trim() : Trim{};
    if (trim.is_empty())
        return;
    const auto trace_cut = [&](const Trim& cut, const Affine& placement, auto& pen) {
        if (cut.is_whole())
            return trace(placement, pen);
        StrokeTrimmer trimmer{cut, placement, PieceSink::of(pen)};
        trimmer.run([&](StrokeTrimmer& pieces) { trace(Affine{}, pieces); });
    };
    if (beam.has_hatching())
        add_hatching(walk, beam,
                     [&](const Affine& placement, auto& pen) { trace_cut(trim.of_fill(), placement, pen); });
    if (!beam.has_outline())
        return;
    const bool is_stroked = walk.node().style.is_stroked;
    draw(is_stroked ? BeamInk::stroke : BeamInk::outline,
         is_stroked ? walk.state().stroke() : walk.state().fill(), walk,
         [&](const Affine& placement, auto& pen) { trace_cut(trim, placement, pen); });
}

template <class Trace>
void BeamTracer::add_hatching(SceneWalk& walk, const BeamStyle& beam, Trace trace)
{
    constexpr int widest = 16;
    for (int wider = coarseness_; wider <= widest; ++wider) {
        Hatching hatching{lines_.spare(), beam, wider, coarseness_};
        trace(Affine{}, hatching);
        if (hatching.is_full())
            continue;
        wider_hatchings_ += wider > 0 ? 1 : 0;
        return draw(BeamInk::stroke, walk.state().fill(), walk, [&](const Affine& placement, BeamPen& pen) {
            hatching.trace(walk.node().style.fill_rule, placement, pen);
        });
    }
    ++wider_hatchings_;
}

/// draw_with(placement, pen) draws something, in its own space, with a pen.
template <class DrawWith>
void BeamTracer::draw(BeamInk ink, Colour colour, SceneWalk& walk, DrawWith draw_with)
{
    const Colour seen = shining(colour, walk.leaf_opacity());
    if (brightness(seen) == 0)
        return;
    const Space& space = walk.space();
    const bool is_flat = space.is_flat();
    const Projection projection{space, on_panel_.camera};
    const ViewProjection view{is_flat ? nullptr : &projection, coarseness_};
    BeamPen pen{lines_, view, resolution_, ink, seen, walk.path()};
    draw_with(is_flat ? space.plane : Affine{}, pen);
}

}
