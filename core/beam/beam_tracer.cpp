#include "core/beam/beam_tracer.hpp"

#include "core/beam/beam_pen.hpp"
#include "core/channel.hpp"
#include "core/item_path.hpp"
#include "core/label_trace.hpp"
#include "core/live_drawing_trace.hpp"
#include "core/object_strokes.hpp"
#include "core/opacity.hpp"
#include "core/paint_order.hpp"
#include "core/projection.hpp"

namespace kfast {
namespace {

/// Over the dark of the display.
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
    still_ = {};
    trace(on_panel_.scene.items(), {on_panel_.canvas});
}

/// Calls itself no deeper than groups and uses may lie in each other, kfb::max_depth.
void BeamTracer::trace(ItemCursor items, const Context& context)
{
    PaintOrder order{items, moment_};
    while (const auto item = order.next())
        trace(*item, context);
}

void BeamTracer::trace(const ItemView& item, const Context& outer)
{
    const ItemState state{on_panel_.scene, item, moment_};
    still_ = still_ & state.still();
    Context context = outer;
    context.path = path_to(item, outer.path, on_panel_.scene);
    context.opacity = product_of_opacities(outer.opacity, state.opacity());
    if (context.opacity == 0)
        return;
    if (!item.tracks.at_end())
        context.space = outer.space * state.placement();
    if (item.kind == ItemKind::object)
        trace_object(item.object, state, context);
    else if (item.kind == ItemKind::live)
        trace_live(item, state, context);
    else
        trace(on_panel_.scene.items_in(item), context);
}

void BeamTracer::trace_object(const ObjectView& object, const ItemState& state, const Context& context)
{
    const ObjectStrokes strokes{on_panel_, object, moment_};
    still_ = still_ & strokes.still();
    add_lines(object.style, state, context,
              [&](const Affine& placement, BeamPen& pen) { strokes.trace(placement, pen); });
}

void BeamTracer::trace_live(const ItemView& item, const ItemState& state, const Context& context)
{
    still_ = still_ & Still{.inputs = bit_of_input(item.live.input)};
    const SceneView& scene = on_panel_.scene;
    add_lines(item.object.style, state, context, [&](const Affine& placement, BeamPen& pen) {
        switch (item.live.kind) {
        case LiveKind::drawing:
            return trace_live_strokes(on_panel_.drawings.of(scene, item.live.input), placement, pen);
        case LiveKind::label:
            return LabelTrace{LabelView::of(item.live.label), on_panel_.texts.glyphs(scene, item.live.input),
                              scene.drawings()}
                .trace(placement, pen);
        }
    });
}

/// trace(placement, pen) tells the strokes to a pen.
template <class Trace>
void BeamTracer::add_lines(const ObjectStyle& style, const ItemState& state, const Context& context,
                           Trace trace)
{
    const Colour colour = shining(style.is_stroked ? state.stroke() : state.fill(), context.opacity);
    if (brightness(colour) == 0)
        return;
    const bool is_flat = context.space.is_flat();
    const Projection projection{context.space, on_panel_.camera};
    BeamPen pen{lines_,      Sight{is_flat ? nullptr : &projection, coarseness_},
                resolution_, style.is_stroked ? BeamInk::stroke : BeamInk::outline,
                colour,      context.path};
    trace(is_flat ? context.space.plane : Affine{}, pen);
}

}
