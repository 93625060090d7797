#include "core/tracer.hpp"

#include "core/blending.hpp"
#include "core/item_path.hpp"
#include "core/label_trace.hpp"
#include "core/live_drawing_trace.hpp"
#include "core/opacity.hpp"
#include "core/paint_order.hpp"
#include "core/work.hpp"

#include <span>
#include <utility>

namespace kfast {
namespace {

Pen pen_for(const ObjectStyle& style, Fixed width, std::int32_t growth)
{
    return {.half_width = half_width(width, growth),
            .cap = style.cap,
            .join = style.join,
            .miter_limit = style.miter_limit};
}

}

void Tracer::run(std::uint32_t moved)
{
    raster::OutlineStore& outlines = picture_.outlines;
    picture_.cache.begin_picture();
    if (picture_.coarseness == 0)
        outlines.keep(moment_.time(), moved);
    else
        outlines.clear();
    picture_.coarseness = 0;
    trace_scene();
    if (outlines.is_full() && outlines.keeps_layers()) {
        outlines.clear();
        trace_scene();
    }
    while (outlines.is_full() && picture_.coarseness < coarsest) {
        ++picture_.coarseness;
        outlines.clear();
        trace_scene();
    }
}

/// After OutlineStore::keep() or clear().
void Tracer::trace_scene()
{
    did(Work::picture);
    picture_.step_count = 0;
    picture_.still = {};
    trace(on_panel_.scene.items(), {.space = on_panel_.canvas});
    work_for(0);
}

/// What lies within something that stays as it is as long as `still` holds.
Tracer::Context Tracer::holding(const Context& outer, const Still& still)
{
    picture_.still = picture_.still & still;
    Context context = outer;
    context.still = outer.still & still;
    return context;
}

/// Calls itself no deeper than groups and uses may lie in each other, kfb::max_depth.
void Tracer::trace(ItemCursor items, const Context& context)
{
    PaintOrder order{items, moment_};
    while (const auto item = order.next())
        trace(*item, context);
}

void Tracer::trace(const ItemView& item, const Context& outer)
{
    const std::uint32_t path = path_to(item, outer.path, on_panel_.scene);
    work_for(path);
    did(Work::item);
    const ItemState state{on_panel_.scene, item, moment_};
    Context context = holding(outer, state.still());
    context.path = path;
    context.opacity = product_of_opacities(outer.opacity, state.opacity());
    if (context.opacity == 0)
        return;
    if (!item.tracks.at_end())
        context.space = outer.space * state.placement();
    if (context.opacity == 255 || !has_several_layers(on_panel_.scene, item))
        return trace(item, state, context);
    const auto opacity = static_cast<std::uint8_t>(std::exchange(context.opacity, 255));
    add_step(raster::PaintStep::Kind::begin_group, context);
    trace(item, state, context);
    add_step(raster::PaintStep::Kind::end_group, context).opacity = opacity;
}

void Tracer::trace(const ItemView& item, const ItemState& state, const Context& context)
{
    if (item.kind == ItemKind::object)
        return trace_object(item.object, state, context);
    if (item.kind == ItemKind::live)
        return trace_live(item, state, context);
    trace(on_panel_.scene.items_in(item), context);
}

/// Whether something that is so still where it lies moves at any time.
bool Tracer::moves(const Still& still) const
{
    return still.inputs != 0 || still.begin > Time{} || still.end <= on_panel_.scene.length();
}

void Tracer::trace_object(const ObjectView& object, const ItemState& state, const Context& outer)
{
    const ObjectStrokes strokes{on_panel_, object, moment_};
    const Context context = holding(outer, strokes.still());
    if (object.has_depths)
        return trace_wires(strokes, object.style, state, context);
    if (const auto carrier = strokes.rigid_carrier())
        if (const auto placement = rigid_placement(*carrier, context))
            return add_rigid_layers(object.style, state, *placement, context, [&](const Pen* pen) {
                trace_rigid(strokes, pen, *placement, object.carrier != Carrier::none || moves(outer.still));
            });
    add_layers(
        object.style, state, context, [&] { return strokes.first_point(); },
        [&](const Affine& placement, ObjectOutline& outline) {
            if (moves(context.still))
                strokes.trace(picture_.cache, placement, outline);
            else
                strokes.trace(placement, outline); // once for all pictures
        });
}

std::optional<RigidPlacement> Tracer::rigid_placement(const Affine& carrier, const Context& context) const
{
    if (!context.space.is_flat())
        return std::nullopt;
    return on_panel_.rigid.of(carrier == Affine{} ? context.space.plane : context.space.plane * carrier);
}

/// Contours of what moves are kept; what never moves is traced once.
void Tracer::trace_rigid(const ObjectStrokes& strokes, const Pen* pen, const RigidPlacement& placement,
                         bool moves)
{
    raster::ContourName name{
        .drawing = strokes.drawing(), .scale_bits = placement.scale_bits, .coarseness = picture_.coarseness};
    if (pen != nullptr) {
        name.half_width = pen->half_width.raw();
        name.pen = static_cast<std::uint8_t>(static_cast<int>(pen->cap) | static_cast<int>(pen->join) << 4);
        name.miter_limit = static_cast<std::uint8_t>(pen->miter_limit);
    }
    const auto trace = [&] {
        trace_upright(placement, pen, [&](const Affine& upright, ObjectOutline& outline) {
            strokes.trace_drawing(upright, outline);
        });
    };
    raster::ContourCache cache{picture_.cache};
    picture_.outlines.place_contours(placement.map, &name, moves ? &cache : nullptr);
    if (!moves)
        trace();
    else if (!cache.each_contour(name,
                                 [&](const raster::KeptContour& kept) { picture_.outlines.add(kept); })) {
        cache.begin(name);
        trace();
        cache.end(!picture_.outlines.is_full());
    }
    picture_.outlines.end_placed();
}

/// Points come as they are seen, and lines stay straight.
void Tracer::trace_wires(const ObjectStrokes& strokes, const ObjectStyle& style, const ItemState& state,
                         const Context& context)
{
    const Projection projection{context.space, on_panel_.camera};
    ObjectOutline outline{picture_.outlines, Sight{nullptr, picture_.coarseness}};
    outline.stroke_with(pen_for(style, state.width(), projection.growth_facing(state.pivot())));
    add_layer(Part::stroke, state.stroke(), FillRule::nonzero, context,
              [&] { strokes.trace(projection, outline); });
}

void Tracer::trace_live(const ItemView& item, const ItemState& state, const Context& outer)
{
    const Context context = holding(outer, {.inputs = bit_of_input(item.live.input)});
    switch (item.live.kind) {
    case LiveKind::drawing:
        return trace_drawing(on_panel_.drawings.of(on_panel_.scene, item.live.input), item.object.style,
                             state, context);
    case LiveKind::label:
        return trace_label(item, state, context);
    }
}

void Tracer::trace_drawing(const LiveDrawing& drawing, const ObjectStyle& style, const ItemState& state,
                           const Context& context)
{
    add_live_layers(
        style, state, context, [&] { return start_of(drawing); },
        [&](const Affine& placement, ObjectOutline& outline) {
            did(Work::object);
            trace_live_strokes(drawing, placement, outline);
        });
}

void Tracer::trace_label(const ItemView& item, const ItemState& state, const Context& context)
{
    const SceneView& scene = on_panel_.scene;
    const LabelTrace label{LabelView::of(item.live.label), on_panel_.texts.glyphs(scene, item.live.input),
                           scene.drawings()};
    add_live_layers(
        item.object.style, state, context, [&] { return label.start(); },
        [&](const Affine& placement, ObjectOutline& outline) { label.trace(placement, outline); });
}

/// As add_layers(), but outlined upright and placed, as drawings of the scene are.
void Tracer::add_live_layers(const ObjectStyle& style, const ItemState& state, const Context& context,
                             FunctionRef<Point()> first_point, TraceStrokes trace)
{
    if (const auto placement = rigid_placement({}, context))
        return add_rigid_layers(style, state, *placement, context, [&](const Pen* pen) {
            picture_.outlines.place_contours(placement->map, nullptr, nullptr);
            trace_upright(*placement, pen, trace);
            picture_.outlines.end_placed();
        });
    add_layers(style, state, context, first_point, trace);
}

/// trace(placement, outline) adds what is painted to an outline.
void Tracer::add_layers(const ObjectStyle& style, const ItemState& state, const Context& context,
                        FunctionRef<Point()> first_point, TraceStrokes trace)
{
    const bool is_flat = context.space.is_flat();
    const Projection projection{context.space, on_panel_.camera};
    ObjectOutline outline{picture_.outlines, Sight{is_flat ? nullptr : &projection, picture_.coarseness}};
    const Affine placement = is_flat ? context.space.plane : Affine{};
    const auto trace_placed = [&] { trace(placement, outline); };
    if (style.is_filled)
        add_layer(Part::fill, state.fill(), style.fill_rule, context, trace_placed);
    if (!style.is_stroked)
        return;
    outline.stroke_with(pen_for(
        style, state.width(), is_flat ? context.space.plane.growth() : projection.growth_at(first_point())));
    add_layer(Part::stroke, state.stroke(), FillRule::nonzero, context, trace_placed);
}

/// trace(pen) adds the contours of the fill if there is no pen.
void Tracer::add_rigid_layers(const ObjectStyle& style, const ItemState& state,
                              const RigidPlacement& placement, const Context& context,
                              FunctionRef<void(const Pen*)> trace)
{
    if (style.is_filled)
        add_layer(Part::fill, state.fill(), style.fill_rule, context, [&] { trace(nullptr); });
    if (!style.is_stroked)
        return;
    const Pen pen = pen_for(style, state.width(), placement.scale);
    add_layer(Part::stroke, state.stroke(), FillRule::nonzero, context, [&] { trace(&pen); });
}

/// Contours that trace(upright placement, outline) adds.
void Tracer::trace_upright(const RigidPlacement& placement, const Pen* pen, TraceStrokes trace)
{
    ObjectOutline outline{picture_.outlines, Sight{nullptr, picture_.coarseness}};
    if (pen != nullptr)
        outline.stroke_with(*pen);
    trace(placement.upright(), outline);
}

raster::PaintStep& Tracer::add_step(raster::PaintStep::Kind kind, const Context& context)
{
    return picture_.add_step({.kind = kind, .item = context.path});
}

void Tracer::add_layer(Part part, Colour colour, FillRule rule, const Context& context,
                       FunctionRef<void()> trace)
{
    colour.opacity = static_cast<std::uint8_t>(product_of_opacities(colour.opacity, context.opacity));
    const raster::PaintStep step{.rule = rule, .colour = colour, .item = context.path};
    picture_.add_layer(step, static_cast<std::uint8_t>(part), context.still, trace);
}

}
