#include "host/picture/svg_tracer.hpp"

#include "core/blending.hpp"
#include "core/label_trace.hpp"
#include "core/live_drawing_trace.hpp"
#include "core/opacity.hpp"
#include "core/paint_order.hpp"
#include "core/projection.hpp"
#include "host/picture/svg_colour.hpp"
#include "host/picture/svg_number.hpp"
#include "host/picture/svg_path.hpp"

#include <utility>

namespace kfast {
namespace {

std::string fill_look(const ObjectStyle& style, Colour colour, std::uint32_t opacity)
{
    return paint_text("fill", colour, opacity) +
           (style.fill_rule == FillRule::even_odd ? " fill-rule=\"evenodd\"" : "");
}

const char* cap_text(Cap cap)
{
    switch (cap) {
    case Cap::butt:
        return "";
    case Cap::round:
        return " stroke-linecap=\"round\"";
    case Cap::square:
        return " stroke-linecap=\"square\"";
    }
    return "";
}

std::string join_text(const ObjectStyle& style)
{
    switch (style.join) {
    case Join::miter:
        return style.miter_limit == default_miter_limit
                   ? ""
                   : " stroke-miterlimit=\"" + svg_number(Fixed::sixteenths(2 * style.miter_limit)) + '"';
    case Join::round:
        return " stroke-linejoin=\"round\"";
    case Join::bevel:
        return " stroke-linejoin=\"bevel\"";
    }
    return "";
}

std::string stroke_look(const ObjectStyle& style, Colour colour, std::uint32_t opacity, Fixed half)
{
    return paint_text("stroke", colour, opacity) + " stroke-width=\"" + svg_number(half + half) + '"' +
           cap_text(style.cap) + join_text(style);
}

}

std::string SvgTracer::run()
{
    elements_.clear();
    trace(on_panel_.scene.items(), {on_panel_.canvas});
    return std::move(elements_);
}

void SvgTracer::trace(ItemCursor items, const Context& context)
{
    PaintOrder order{items, moment_};
    while (const auto item = order.next())
        trace(*item, context);
}

void SvgTracer::trace(const ItemView& item, const Context& outer)
{
    Context context = outer;
    const ItemState state{on_panel_.scene, item, moment_};
    context.opacity = product_of_opacities(outer.opacity, state.opacity());
    if (context.opacity == 0)
        return;
    if (!item.tracks.at_end())
        context.space = outer.space * state.placement();
    if (context.opacity == 255 || !has_several_layers(on_panel_.scene, item))
        return trace(item, state, context);
    elements_ += "<g opacity=\"" + svg_share(std::exchange(context.opacity, 255)) + "\">\n";
    trace(item, state, context);
    elements_ += "</g>\n";
}

void SvgTracer::trace(const ItemView& item, const ItemState& state, const Context& context)
{
    if (item.kind == ItemKind::object)
        return trace_object(item.object, state, context);
    if (item.kind == ItemKind::live)
        return trace_live(item, state, context);
    trace(on_panel_.scene.items_in(item), context);
}

void SvgTracer::trace_object(const ObjectView& object, const ItemState& state, const Context& context)
{
    const ObjectStrokes strokes{on_panel_, object, moment_};
    if (object.has_depths)
        return trace_wires(strokes, object.style, state, context);
    add_paths(object.style, state, context, strokes.first_point(),
              [&](const Affine& placement, SvgPath& path) { strokes.trace(placement, path); });
}

/// Points come as they are seen.
void SvgTracer::trace_wires(const ObjectStrokes& strokes, const ObjectStyle& style, const ItemState& state,
                            const Context& context)
{
    const Projection projection{context.space, on_panel_.camera};
    SvgPath path{nullptr, SvgPath::Use::stroke};
    strokes.trace(projection, path);
    const Fixed half = half_width(state.width(), projection.growth_facing(state.pivot()));
    add_path(path.data(), " fill=\"none\"" + stroke_look(style, state.stroke(), context.opacity, half));
}

void SvgTracer::trace_live(const ItemView& item, const ItemState& state, const Context& context)
{
    const SceneView& scene = on_panel_.scene;
    switch (item.live.kind) {
    case LiveKind::drawing: {
        const LiveDrawing drawing = on_panel_.drawings.of(scene, item.live.input);
        return add_paths(
            item.object.style, state, context, start_of(drawing),
            [&](const Affine& placement, SvgPath& path) { trace_live_strokes(drawing, placement, path); });
    }
    case LiveKind::label: {
        const LabelTrace label{LabelView::of(item.live.label), on_panel_.texts.glyphs(scene, item.live.input),
                               scene.drawings()};
        return add_paths(item.object.style, state, context, label.start(),
                         [&](const Affine& placement, SvgPath& path) { label.trace(placement, path); });
    }
    }
}

/// trace(placement, path) writes the strokes, of which `first` is the first point. A fill and a stroke that
/// go the same way become one path.
template <class Trace>
void SvgTracer::add_paths(const ObjectStyle& style, const ItemState& state, const Context& context,
                          Point first, Trace trace)
{
    const bool is_flat = context.space.is_flat();
    const Projection projection{context.space, on_panel_.camera};
    const auto data = [&](SvgPath::Use use) {
        SvgPath path{is_flat ? nullptr : &projection, use};
        trace(is_flat ? context.space.plane : Affine{}, path);
        return path.data();
    };
    const std::string filled = style.is_filled ? data(SvgPath::Use::fill) : "";
    const std::string fill = style.is_filled ? fill_look(style, state.fill(), context.opacity) : "";
    if (!style.is_stroked)
        return add_path(filled, fill);
    const std::int32_t growth = is_flat ? context.space.plane.growth() : projection.growth_at(first);
    const std::string stroke =
        stroke_look(style, state.stroke(), context.opacity, half_width(state.width(), growth));
    const std::string stroked = data(SvgPath::Use::stroke);
    if (style.is_filled && filled == stroked)
        return add_path(filled, fill + stroke);
    if (style.is_filled)
        add_path(filled, fill);
    add_path(stroked, " fill=\"none\"" + stroke);
}

void SvgTracer::add_path(const std::string& data, const std::string& look)
{
    if (!data.empty())
        elements_ += "<path" + look + " d=\"" + data + "\"/>\n";
}

}
