#include "core/tracer.hpp"

#include "core/bytes/op_counter.hpp"
#include "core/features.hpp"
#include "core/pixel/paint_style.hpp"
#include "core/pose/input_drawing.hpp"
#include "core/pose/label_layout.hpp"

namespace kfast {
namespace {

Pen pen_for(const ObjectStyle& style, Fixed width, std::int32_t scale_factor)
{
    return {.half_width = half_width(width, scale_factor),
            .cap = style.cap,
            .join = style.join,
            .miter_limit = style.miter_limit};
}

}

void Tracer::run()
{
    raster::OutlineStore& outlines = picture_.outlines;
    picture_.cache.begin_picture();
    if (picture_.coarseness == 0)
        outlines.keep(on_panel_.prepared.moved());
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

/// Called after OutlineStore::keep() or clear().
void Tracer::trace_scene()
{
    using Step = SceneWalk::Step;
    using Kind = raster::PaintStep::Kind;
    count_op(Op::picture);
    picture_.step_count = 0;
    SceneWalk walk{on_panel_, SceneWalk::Opacity::of_groups};
    for (Step step = walk.next(); step != Step::end; step = walk.next()) {
        if (step == Step::begin_group)
            picture_.add_step({.kind = Kind::begin_group, .item = walk.path()});
        else if (step == Step::end_group)
            picture_.add_step({.kind = Kind::end_group,
                               .opacity = static_cast<std::uint8_t>(walk.group_opacity()),
                               .item = walk.path()});
        else
            trace_leaf(walk);
        if (picture_.outlines.is_full() && picture_.coarseness < coarsest)
            break; // all of it is traced again
    }
    picture_.dependence = walk.whole();
    count_ops_for(0);
}

void Tracer::trace_leaf(SceneWalk& walk)
{
    if (reuse_layers(walk))
        return;
    if (walk.node().kind == ItemKind::object)
        return trace_object(walk);
    trace_live(walk);
}

/// If all layers of a leaf are kept, nothing else has to be known about it.
bool Tracer::reuse_layers(const SceneWalk& walk)
{
    const raster::OutlineStore& outlines = picture_.outlines;
    const ObjectStyle& style = walk.node().style;
    const auto is_kept = [&](Part part) {
        return outlines.keeps({walk.path(), static_cast<std::uint8_t>(part)});
    };
    if ((style.is_filled && !is_kept(Part::fill)) || (style.is_stroked && !is_kept(Part::stroke)))
        return false;
    const auto nothing = [] {};
    if (style.is_filled)
        add_layer(Part::fill, walk, nothing);
    if (style.is_stroked)
        add_layer(Part::stroke, walk, nothing);
    return true;
}

void Tracer::trace_object(SceneWalk& walk)
{
    const Node& object = walk.node();
    const ObjectStrokes strokes{on_panel_, object};
    if (object.has_depths)
        return on_panel_.scene.features().wires->trace(*this, strokes, walk);
    if (const auto deformer = object.is_cut ? std::nullopt : strokes.rigid_deformation())
        if (const auto placement = rigid_placement(*deformer, walk.space())) {
            const bool moves = object.deformer != Deformer::none || walk.place_dependence().keys != 0;
            return add_rigid_layers(walk, *placement,
                                    [&](const Pen* pen) { trace_rigid(strokes, pen, *placement, moves); });
        }
    add_layers(
        walk, [&] { return strokes.first_point(); },
        [&](const Affine& placement, ObjectOutline& outline) {
            if (walk.leaf_dependence().keys != 0)
                strokes.trace(picture_.cache, placement, outline);
            else
                strokes.trace(placement, outline); // once for all pictures
        });
}

std::optional<RigidPlacement> Tracer::rigid_placement(const Affine& deformer, const Space& space) const
{
    if (!space.is_flat())
        return std::nullopt;
    return on_panel_.rigid.of(deformer == Affine{} ? space.plane : space.plane * deformer);
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

/// Points are projected already, and lines stay straight.
void Tracer::trace_wires(const ObjectStrokes& strokes, SceneWalk& walk)
{
    const ItemState state = walk.state();
    const Projection projection{walk.space(), on_panel_.camera};
    ObjectOutline outline{picture_.outlines, ViewProjection{nullptr, picture_.coarseness}};
    outline.stroke_with(
        pen_for(walk.node().style, state.width(), projection.scale_factor_facing(state.pivot())), pens());
    add_layer(Part::stroke, walk, [&] { strokes.trace(projection, outline); });
}

void Tracer::trace_live(SceneWalk& walk)
{
    const Features& features = on_panel_.scene.features();
    if (walk.node().live == InputLeaf::label)
        return features.texts->trace(*this, walk);
    features.drawings->trace(*this, walk);
}

void Tracer::trace_drawing(SceneWalk& walk)
{
    const InputDrawing drawing = on_panel_.drawings.of(on_panel_.scene, walk.node().of);
    add_live_layers(
        walk, [&] { return start_of(drawing); },
        [&](const Affine& placement, ObjectOutline& outline) {
            count_op(Op::object);
            trace_live_strokes(drawing, placement, outline);
        });
}

void Tracer::trace_label(SceneWalk& walk)
{
    const LabelTrace label = label_of(on_panel_, item_view(on_panel_.scene, walk.node()).live);
    add_live_layers(
        walk, [&] { return label.start(); },
        [&](const Affine& placement, ObjectOutline& outline) { label.trace(placement, outline); });
}

/// As add_layers(), but outlined upright and placed, as drawings of the scene are.
void Tracer::add_live_layers(SceneWalk& walk, FunctionRef<Point()> first_point, TraceStrokes trace)
{
    if (const auto placement = walk.node().is_cut ? std::nullopt : rigid_placement({}, walk.space()))
        return add_rigid_layers(walk, *placement, [&](const Pen* pen) {
            picture_.outlines.place_contours(placement->map, nullptr, nullptr);
            trace_upright(*placement, pen, trace);
            picture_.outlines.end_placed();
        });
    add_layers(walk, first_point, trace);
}

/// trace(placement, outline) adds what is painted to an outline.
void Tracer::add_layers(SceneWalk& walk, FunctionRef<Point()> first_point, TraceStrokes trace)
{
    const Affine& plane = walk.space().plane;
    if (!walk.space().is_flat())
        return on_panel_.scene.features().depth->add_layers(*this, walk, first_point, trace);
    add_layers(
        walk, ViewProjection{nullptr, picture_.coarseness}, plane, [&] { return plane.scale_factor(); },
        trace);
}

void Tracer::add_layers_in_depth(SceneWalk& walk, FunctionRef<Point()> first_point, TraceStrokes trace)
{
    const Projection projection{walk.space(), on_panel_.camera};
    add_layers(
        walk, ViewProjection{&projection, picture_.coarseness}, Affine{},
        [&] { return projection.scale_factor_at(first_point()); }, trace);
}

/// scale_factor() is the scale of the pen.
void Tracer::add_layers(SceneWalk& walk, const ViewProjection& view, const Affine& placement,
                        FunctionRef<std::int32_t()> scale_factor, TraceStrokes trace)
{
    const ObjectStyle& style = walk.node().style;
    ObjectOutline outline{picture_.outlines, view};
    const Trim trim = walk.node().is_cut ? walk.state().trim() : Trim{};
    const auto trace_cut = [&](const Trim& cut) {
        if (cut.is_whole())
            trace(placement, outline);
        else if (!cut.is_empty())
            on_panel_.scene.features().trims->trace(cut, placement, outline, trace);
    };
    if (style.is_filled)
        add_layer(Part::fill, walk, [&] { trace_cut(trim.of_fill()); });
    if (!style.is_stroked)
        return;
    outline.stroke_with(pen_for(style, walk.state().width(), scale_factor()), pens());
    add_layer(Part::stroke, walk, [&] { trace_cut(trim); });
}

/// trace(pen) adds the contours of the fill if there is no pen.
void Tracer::add_rigid_layers(SceneWalk& walk, const RigidPlacement& placement,
                              FunctionRef<void(const Pen*)> trace)
{
    const ObjectStyle& style = walk.node().style;
    if (style.is_filled)
        add_layer(Part::fill, walk, [&] { trace(nullptr); });
    if (!style.is_stroked)
        return;
    const Pen pen = pen_for(style, walk.state().width(), placement.scale);
    add_layer(Part::stroke, walk, [&] { trace(&pen); });
}

/// Adds contours that trace(upright placement, outline) makes.
void Tracer::trace_upright(const RigidPlacement& placement, const Pen* pen, TraceStrokes trace)
{
    ObjectOutline outline{picture_.outlines, ViewProjection{nullptr, picture_.coarseness}};
    if (pen != nullptr)
        outline.stroke_with(*pen, pens());
    trace(placement.upright(), outline);
}

/// trace() adds its outlines if they are not kept.
void Tracer::add_layer(Part part, const SceneWalk& walk, FunctionRef<void()> trace)
{
    const ItemState state = walk.state();
    Colour colour = part == Part::fill ? state.fill() : state.stroke();
    colour.opacity = static_cast<std::uint8_t>(product_of_opacities(colour.opacity, walk.leaf_opacity()));
    const FillRule rule = part == Part::fill ? walk.node().style.fill_rule : FillRule::nonzero;
    picture_.add_layer({.rule = rule, .colour = colour, .item = walk.path()}, static_cast<std::uint8_t>(part),
                       walk.leaf_dependence(), trace);
}

}
