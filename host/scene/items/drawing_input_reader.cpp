#include "host/scene/items/input_reader.hpp"

#include "host/scene/context/limits.hpp"
#include "host/scene/items/drawing_reader.hpp"
#include "host/scene/shapes/shape_reader.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/schema/node_form.hpp"
#include "host/schema/property_rule.hpp"
#include "host/text/characters.hpp"
#include "host/text/number_text.hpp"
#include "host/words/synonyms.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace kfast::scene {
namespace {

constexpr Range amounts{1, max_live_points};

template <std::size_t DrawingInput::*amount>
bool read_amount(const kdl::Value& value, DrawingInput& input, SceneContext& context)
{
    return assign(read_whole_number(value, amounts, context.report), input.*amount);
}

constexpr std::array drawing_rules{
    PropertyRule<DrawingInput>{"kind", check_own_type<DrawingInput>, ValueKind::one_of<input_types>()},
    PropertyRule<DrawingInput>{"points", read_amount<&DrawingInput::points>, ValueKind::whole(amounts), true},
    PropertyRule<DrawingInput>{"strokes", read_amount<&DrawingInput::strokes>, ValueKind::whole(amounts)},
};

bool is_straight(const Stroke& stroke)
{
    return std::ranges::none_of(stroke.segments, [](const Segment& segment) { return segment.cubic; });
}

Drawing read_shape(const kdl::Node& node, SceneContext& context)
{
    DrawingReader reader{context};
    reader.read(node);
    Drawing drawing = reader.take();
    if (!std::ranges::all_of(drawing.strokes, is_straight))
        context.report.error(node.name_span, "the drawing of an input has straight lines only",
                             "draw it with lines, polygons, or rectangles without round corners");
    return drawing;
}

void report_unknown(const kdl::Node& node, SceneContext& context)
{
    context.report.error(node.name_span, "the drawing of an input has no node " + in_quotes(node.name),
                         word_hint(node.name, shape_names()));
}

Drawing read_shapes(const kdl::Node& node, SceneContext& context)
{
    Drawing drawing;
    for (const kdl::Node& child : node.children) {
        if (context.report.full())
            break;
        if (!is_shape(child.name)) {
            report_unknown(child, context);
            continue;
        }
        for (Stroke& stroke : read_shape(child, context).strokes)
            drawing.strokes.push_back(std::move(stroke));
    }
    return drawing;
}

void check_amounts(const kdl::Node& node, const DrawingInput& input, SceneContext& context)
{
    const std::size_t points = point_count(input.default_value);
    const std::size_t strokes = input.default_value.strokes.size();
    if (input.strokes > input.points)
        context.report.error(property_span(node, "strokes"), "these are more strokes than points",
                             "each stroke has a point at least");
    if (points > input.points)
        context.report.error(property_span(node, "points"),
                             "the drawing inside has " + counted(points, "point"),
                             "write points=" + std::to_string(points) + ", or draw less");
    if (strokes > input.strokes)
        context.report.error(property_span(node, "strokes"),
                             "the drawing inside has " + counted(strokes, "stroke"),
                             "write strokes=" + std::to_string(strokes) + ", or draw less");
}

}

DrawingInput read_drawing_input(const kdl::Node& node, SceneContext& context)
{
    DrawingInput input;
    const bool is_valid = read_properties(node, drawing_rules, input, context);
    input.default_value = read_shapes(node, context);
    take_points(1, node.name_span, context);
    if (is_valid)
        check_amounts(node, input, context);
    return input;
}

std::vector<PropertySchema> drawing_input_schema() { return schema_of(drawing_rules); }

}
