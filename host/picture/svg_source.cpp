#include "host/picture/svg_source.hpp"

#include "core/math/projection.hpp"
#include "core/pose/input_drawing.hpp"
#include "core/pose/label_layout.hpp"
#include "core/pose/object_strokes.hpp"
#include "core/pose/scene_state.hpp"
#include "core/scene_walk.hpp"
#include "host/picture/svg_attributes.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace kfast {

namespace {

/// Everything visible in a scene at the time to which it was moved, as elements of an SVG, in the order
/// of painting. It makes paths and groups where Tracer makes layers and blends.
class SvgTracer {
public:
    /// The bones of the scene must have been posed.
    explicit SvgTracer(const SceneOnPanel& scene) : on_panel_{scene} {}

    std::string run();

private:
    void trace_leaf(SceneWalk& walk);
    void trace_object(SceneWalk& walk);
    void trace_wires(SceneWalk& walk, const ObjectStrokes& strokes);
    void trace_live(SceneWalk& walk);
    template <class Trace>
    void add_paths(SceneWalk& walk, Point first, Trace trace);
    void add_path(const std::string& data, const std::string& look);

    const SceneOnPanel& on_panel_;
    std::string elements_;
};

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

std::string SvgTracer::run()
{
    using Step = SceneWalk::Step;
    elements_.clear();
    SceneWalk walk{on_panel_, SceneWalk::Opacity::of_groups};
    for (Step step = walk.next(); step != Step::end; step = walk.next()) {
        if (step == Step::begin_group)
            elements_ += "<g opacity=\"" + svg_share(walk.group_opacity()) + "\">\n";
        else if (step == Step::end_group)
            elements_ += "</g>\n";
        else
            trace_leaf(walk);
    }
    return std::move(elements_);
}

void SvgTracer::trace_leaf(SceneWalk& walk)
{
    if (walk.node().kind == ItemKind::object)
        trace_object(walk);
    else
        trace_live(walk);
}

void SvgTracer::trace_object(SceneWalk& walk)
{
    const ObjectStrokes strokes{on_panel_, walk.node()};
    if (walk.node().has_depths)
        return trace_wires(walk, strokes);
    add_paths(walk, strokes.first_point(),
              [&](const Affine& placement, auto& path) { strokes.trace(placement, path); });
}

/// Points are projected already.
void SvgTracer::trace_wires(SceneWalk& walk, const ObjectStrokes& strokes)
{
    const ItemState state = walk.state();
    const Projection projection{walk.space(), on_panel_.camera};
    SvgPath path{nullptr, SvgPath::Use::stroke};
    strokes.trace(projection, path);
    const Fixed half = half_width(state.width(), projection.scale_factor_facing(state.pivot()));
    add_path(path.data(),
             " fill=\"none\"" + stroke_look(walk.node().style, state.stroke(), walk.leaf_opacity(), half));
}

void SvgTracer::trace_live(SceneWalk& walk)
{
    const SceneView& scene = on_panel_.scene;
    const LiveView live = item_view(scene, walk.node()).live;
    switch (live.kind) {
    case InputLeaf::drawing: {
        const InputDrawing drawing = on_panel_.drawings.of(scene, live.input);
        return add_paths(walk, start_of(drawing), [&](const Affine& placement, auto& path) {
            trace_live_strokes(drawing, placement, path);
        });
    }
    case InputLeaf::label: {
        const LabelTrace label = label_of(on_panel_, live);
        return add_paths(walk, label.start(),
                         [&](const Affine& placement, auto& path) { label.trace(placement, path); });
    }
    }
}

/// trace(placement, path) writes the strokes, of which `first` is the first point. A fill and a stroke that
/// follow the same path become one path.
template <class Trace>
void SvgTracer::add_paths(SceneWalk& walk, Point first, Trace trace)
{
    const ObjectStyle& style = walk.node().style;
    const ItemState state = walk.state();
    const std::uint32_t opacity = walk.leaf_opacity();
    const Space& space = walk.space();
    const bool is_flat = space.is_flat();
    const Projection projection{space, on_panel_.camera};
    const Trim trim = walk.node().is_cut ? state.trim() : Trim{};
    const auto data = [&](SvgPath::Use use) {
        SvgPath path{is_flat ? nullptr : &projection, use};
        const Affine placement = is_flat ? space.plane : Affine{};
        const Trim cut = use == SvgPath::Use::fill ? trim.of_fill() : trim;
        if (cut.is_whole()) {
            trace(placement, path);
        } else if (!cut.is_empty()) {
            StrokeTrimmer trimmer{cut, placement, PieceSink::of(path)};
            trimmer.run([&](StrokeTrimmer& pieces) { trace(Affine{}, pieces); });
        }
        return path.data();
    };
    const std::string filled = style.is_filled ? data(SvgPath::Use::fill) : "";
    const std::string fill = style.is_filled ? fill_look(style, state.fill(), opacity) : "";
    if (!style.is_stroked)
        return add_path(filled, fill);
    const std::int32_t scale_factor =
        is_flat ? space.plane.scale_factor() : projection.scale_factor_at(first);
    const std::string stroke =
        stroke_look(style, state.stroke(), opacity, half_width(state.width(), scale_factor));
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

SvgSource::SvgSource(const SceneView& scene, Size panel, Fit fit)
    : panel_{panel}, memory_{SvgPlayer::bytes_for(scene)}, player_{scene, panel, fit, memory_.bytes()}
{
}

std::string SvgSource::SvgPlayer::show(Time moment)
{
    pose(std::clamp(moment, Time{}, scene().length()));
    return SvgTracer{on_panel()}.run();
}

}
