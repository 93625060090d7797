#include "host/scene/items/drawing_reader.hpp"

#include "core/math/angle.hpp"
#include "host/geometry/outline.hpp"
#include "host/scene/context/limits.hpp"
#include "host/scene/items/drawing_content.hpp"
#include "host/scene/items/symbol_use.hpp"
#include "host/scene/shapes/shape_reader.hpp"
#include "host/scene/shapes/wire_reader.hpp"
#include "host/scene/values/item_values.hpp"
#include "host/schema/node_form.hpp"
#include "host/schema/property_rule.hpp"
#include "host/text/characters.hpp"
#include "host/words/scene_words.hpp"

#include <algorithm>
#include <string>

namespace kfast::scene {

namespace {

/// The placement of a copy of a drawing: scaled and rotated about (0, 0), then moved.
class Placement {
public:
    /// Uses the position, rotation and scale of `values`.
    explicit Placement(const ItemValues& values);

    Vec2 of(Vec2 spot) const;
    Outline of(const Outline& outline) const;

private:
    Vec2 origin_;
    Vec2 x_axis_; ///< the image of (1, 0), without the move
    Vec2 y_axis_;
};

double value_of(const ItemValues& values, Property property, std::int32_t ordinary, double unit)
{
    return values.get(property).value_or(ordinary) / unit;
}

Placement::Placement(const ItemValues& values)
    : origin_{value_of(values, Property::x, 0, 16), value_of(values, Property::y, 0, 16)}
{
    const auto angle = BinaryAngle::from_raw(values.get(Property::rotation).value_or(0));
    const Vec2 direction{static_cast<double>(cosine(angle)) / one_q30,
                         static_cast<double>(sine(angle)) / one_q30};
    x_axis_ = value_of(values, Property::scale_x, scale_one, scale_one) * direction;
    y_axis_ = value_of(values, Property::scale_y, scale_one, scale_one) * Vec2{-direction.y, direction.x};
}

Vec2 Placement::of(Vec2 spot) const { return origin_ + spot.x * x_axis_ + spot.y * y_axis_; }

Outline Placement::of(const Outline& outline) const
{
    Outline placed{.from = of(outline.from),
                   .curves = {},
                   .closed = outline.closed,
                   .begins_letter = outline.begins_letter};
    placed.curves.reserve(outline.curves.size());
    for (const Curve& curve : outline.curves)
        placed.curves.push_back(curve.cubic ? cubic_to(of(curve.c1), of(curve.c2), of(curve.to))
                                            : line_to(of(curve.to)));
    return placed;
}

constexpr NodeForm empty_form{"empty", "key TIME { empty }"};

/// Whether a copy of a symbol stays in the plane of its drawing, as it must; reports it if not.
bool lies_flat(const kdl::Node& use, const ItemValues& values, SceneContext& context)
{
    for (const Property property : {Property::z, Property::rotation_x, Property::rotation_y})
        if (values.get(property))
            return context.report.error(
                property_span(use, property_name(property)),
                "among shapes a use is a copy, which lies in the plane of its drawing",
                "let the use be all that an object draws, or turn the object");
    return true;
}

void report_moving_symbol(const kdl::Node& use, const SymbolEntry& symbol, SceneContext& context)
{
    const SourceSpan name = use.arguments.front().place;
    const std::string has_keys = "the symbol " + in_quotes(symbol.name) + " has keys, ";
    if (has_property(use, "count"))
        context.report.error(name, has_keys + "and there are no copies of such a drawing",
                             "leave out count=, draw the symbol without keys, or let it hold an object");
    else
        context.report.error(name, has_keys + "which do not fit here",
                             "let its use be all that an object without skin draws, or use one without keys");
}

bool report_reach(const kdl::Node& node, SceneContext& context)
{
    return context.report.error(node.name_span,
                                "this " + node.name + " reaches more than 2047 px from the origin");
}

}

std::vector<std::string_view> drawn_names()
{
    std::vector<std::string_view> names{shape_names().begin(), shape_names().end()};
    names.insert(names.end(), wire_names().begin(), wire_names().end());
    names.push_back(use_name);
    names.push_back(empty_form.name);
    return names;
}

bool is_drawn(std::string_view name)
{
    return is_shape(name) || is_wire(name) || name == use_name || name == empty_form.name;
}

void DrawingReader::read(const kdl::Node& node)
{
    const bool is_empty = node.name == empty_form.name;
    if (is_empty ? has_strokes_ : is_empty_)
        context_.report.error(node.name_span, "\"empty\" stands alone", "remove it, or the shapes");
    if (is_empty)
        read_empty(node);
    else
        read_strokes(node);
}

void DrawingReader::read_empty(const kdl::Node& node)
{
    is_empty_ = true;
    if (fits(node, empty_form, context_.report))
        refuse_properties(node, context_.report);
}

void DrawingReader::read(std::span<const kdl::Node* const> nodes)
{
    for (const kdl::Node* node : nodes)
        if (!context_.report.full())
            read(*node);
}

void DrawingReader::read_strokes(const kdl::Node& node)
{
    has_strokes_ = true;
    if (!goes_with_others(node))
        return;
    if (node.name == use_name)
        return copy(node);
    if (is_wire(node.name)) {
        for (const Wire& wire : read_wires(node, context_))
            if (!add(wire, node))
                return;
        return;
    }
    for (Outline& outline : read_shape(node, max_points - points_, context_))
        if (!add(std::move(outline), node))
            return;
}

/// Whether `node` has a depth exactly if the nodes before it have one; reports the first that differs.
bool DrawingReader::goes_with_others(const kdl::Node& node)
{
    const bool has_depth = is_wire(node.name);
    if (has_depths_.value_or(has_depth) != has_depth && !std::exchange(is_mixed_, true))
        context_.report.error(node.name_span,
                              "flat shapes and such with depth do not go together in one drawing",
                              "put them into an object each, and a group around both");
    has_depths_ = has_depths_.value_or(has_depth);
    return !is_mixed_;
}

void DrawingReader::copy(const kdl::Node& node)
{
    const auto use = read_drawing_use(node, context_);
    if (!use)
        return;
    const SymbolEntry& symbol = *use->symbol;
    const SourceSpan name = node.arguments.front().place;
    if (!symbol.still) {
        report_moving_symbol(node, symbol, context_);
        return;
    }
    if (use->time.is_given()) {
        context_.report.error(name,
                              "the symbol " + in_quotes(symbol.name) + " has no keys, which a time moves",
                              "leave out delay=, speed= and loop=");
        return;
    }
    if (is_wire_frame(symbol.keys)) {
        context_.report.error(name,
                              "the symbol " + in_quotes(symbol.name) + " has depth, and does not fit here",
                              "let its use be all that an object draws");
        return;
    }
    depth_ = std::max(depth_, symbol.depth + 1);
    if (depth_ > deepest_item) {
        context_.report.error(name, too_deep());
        return;
    }
    if (!lies_flat(node, use->values, context_))
        return;
    ItemValues values = use->values;
    mirror(use->mirror, values, {}, {});
    const Placement placement{values};
    warn_of_unseen_copies(node, use->repeat, context_);
    for (int number = 0; number < use->repeat.count.value_or(1); ++number) {
        const auto step = use->repeat.copy(number, {});
        if (!step) {
            report_far_copy(node, number, use->repeat, context_);
            return;
        }
        const Placement within{*step};
        for (const Outline& outline : *symbol.still)
            if (!add(placement.of(within.of(outline)), node))
                return;
    }
}

namespace {

/// Of an outline with a sector.
SectorForm form_of(const Outline& outline)
{
    if (!outline.closed)
        return SectorForm::arc;
    const Vec2 centre = outline.sector->centre;
    const bool is_from_centre = outline.from.x == centre.x && outline.from.y == centre.y;
    return is_from_centre ? SectorForm::pie : SectorForm::ring_piece;
}

}

bool DrawingReader::add(Outline outline, const kdl::Node& node)
{
    if (!in_range(outline))
        return report_reach(node, context_);
    if (!take_points(outline.curves.size() + 1, node.name_span, context_))
        return false;
    Stroke stroke = quantized(outline);
    if (!has_capacity(stroke.segments.size() + 1, node))
        return false;
    if (outline.sector)
        sectors_.push_back({drawing_.strokes.size(), *outline.sector, form_of(outline)});
    const bool is_other_node = std::exchange(last_node_, &node) != &node;
    if (outline.begins_letter || is_other_node)
        letters_.push_back(drawing_.strokes.size());
    drawing_.strokes.push_back(std::move(stroke));
    outlines_.push_back(std::move(outline));
    return true;
}

bool DrawingReader::add(const Wire& wire, const kdl::Node& node)
{
    if (!in_range(wire))
        return report_reach(node, context_);
    if (!take_points(2 * wire.size(), node.name_span, context_) || !has_capacity(wire.size(), node))
        return false;
    WireStroke stroke = quantized(wire);
    drawing_.strokes.push_back(std::move(stroke.flat));
    depths_.strokes.push_back(std::move(stroke.depths));
    return true;
}

bool DrawingReader::has_capacity(std::size_t points, const kdl::Node& node)
{
    if (points > max_points - points_)
        return context_.report.error(node.name_span, too_many_points());
    points_ += points;
    return true;
}

std::vector<std::string_view> drawn_ids(std::vector<std::string_view> names)
{
    std::ranges::replace(names, use_name, drawing_use_id);
    return names;
}

NodeSchema empty_schema() { return {empty_form.name, empty_form}; }

}
