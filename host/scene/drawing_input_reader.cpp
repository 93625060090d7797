#include "host/scene/drawing_input_reader.hpp"

#include "host/scene/drawing_reader.hpp"
#include "host/scene/input_type.hpp"
#include "host/scene/limits.hpp"
#include "host/scene/node_words.hpp"
#include "host/scene/property_rule.hpp"
#include "host/scene/shape_reader.hpp"
#include "host/scene/synonyms.hpp"
#include "host/scene/value_reader.hpp"
#include "host/text/counted.hpp"
#include "host/text/glyph.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace kfast::scene {
namespace {

constexpr Range amounts{1, most_live_points};

template <std::size_t DrawingInput::*amount>
bool read_amount(const kdl::Value& value, DrawingInput& input, Reading& reading)
{
    return assign(read_whole_number(value, amounts, reading), input.*amount);
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

Drawing read_shape(const kdl::Node& node, Reading& reading)
{
    DrawingReader reader{reading};
    reader.read(node);
    Drawing drawing = reader.take();
    if (!std::ranges::all_of(drawing.strokes, is_straight))
        reading.report.error(node.name_place, "the drawing of an input has straight lines only",
                             "draw it with lines, polygons, or rectangles without round corners");
    return drawing;
}

void report_unknown(const kdl::Node& node, Reading& reading)
{
    reading.report.error(node.name_place, "the drawing of an input has no node " + in_quotes(node.name),
                         word_remedy(node.name, shape_names()));
}

Drawing read_shapes(const kdl::Node& node, Reading& reading)
{
    Drawing drawing;
    for (const kdl::Node& child : node.children) {
        if (reading.report.full())
            break;
        if (!is_shape(child.name)) {
            report_unknown(child, reading);
            continue;
        }
        for (Stroke& stroke : read_shape(child, reading).strokes)
            drawing.strokes.push_back(std::move(stroke));
    }
    return drawing;
}

void check_amounts(const kdl::Node& node, const DrawingInput& input, Reading& reading)
{
    const std::size_t points = point_count(input.usual);
    const std::size_t strokes = input.usual.strokes.size();
    if (input.strokes > input.points)
        reading.report.error(property_place(node, "strokes"), "these are more strokes than points",
                             "each stroke has a point at least");
    if (points > input.points)
        reading.report.error(property_place(node, "points"),
                             "the drawing inside has " + counted(points, "point"),
                             "write points=" + std::to_string(points) + ", or draw less");
    if (strokes > input.strokes)
        reading.report.error(property_place(node, "strokes"),
                             "the drawing inside has " + counted(strokes, "stroke"),
                             "write strokes=" + std::to_string(strokes) + ", or draw less");
}

}

DrawingInput read_drawing_input(const kdl::Node& node, Reading& reading)
{
    DrawingInput input;
    const bool is_good = read_properties(node, drawing_rules, input, reading);
    input.usual = read_shapes(node, reading);
    take_points(1, node.name_place, reading);
    if (is_good)
        check_amounts(node, input, reading);
    return input;
}

std::vector<PropertyWords> drawing_input_words() { return words_of(drawing_rules); }

}
