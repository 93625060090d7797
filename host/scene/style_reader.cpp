#include "host/scene/style_reader.hpp"

#include "host/scene/limits.hpp"
#include "host/scene/property_rule.hpp"
#include "host/scene/value_reader.hpp"

#include <cmath>

namespace kfast::scene {
namespace {

constexpr std::array caps{Word<Cap>{"butt", Cap::butt}, Word<Cap>{"round", Cap::round},
                          Word<Cap>{"square", Cap::square}};
constexpr std::array joins{Word<Join>{"miter", Join::miter}, Word<Join>{"round", Join::round},
                           Word<Join>{"bevel", Join::bevel}};
constexpr Range widths{1.0 / 16, widest_stroke};

struct Style {
    std::optional<std::size_t> fill;
    std::optional<std::size_t> stroke;
    StrokeStyle rest; ///< of the stroke; its colour counts for nothing
};

bool read_fill(const kdl::Value& value, Style& style, Reading& reading)
{
    return assign(read_colour(value, reading), style.fill);
}

bool read_stroke(const kdl::Value& value, Style& style, Reading& reading)
{
    return assign(read_colour(value, reading), style.stroke);
}

/// Rounded once to 1/16 px, halves away from zero.
bool read_width(const kdl::Value& value, Style& style, Reading& reading)
{
    const auto width = read_number(value, widths, reading);
    if (width)
        style.rest.width = static_cast<int>(std::lround(*width * 16));
    return width.has_value();
}

bool read_cap(const kdl::Value& value, Style& style, Reading& reading)
{
    return assign(read_word(value, caps, reading), style.rest.cap);
}

bool read_join(const kdl::Value& value, Style& style, Reading& reading)
{
    return assign(read_word(value, joins, reading), style.rest.join);
}

constexpr std::array style_rules{
    PropertyRule<Style>{"fill", read_fill},
    PropertyRule<Style>{"stroke", read_stroke},
    PropertyRule<Style>{"width", read_width, false, "stroke"},
    PropertyRule<Style>{"cap", read_cap, false, "stroke"},
    PropertyRule<Style>{"join", read_join, false, "stroke"},
};

}

void read_style(const kdl::Node& node, Object& object, Reading& reading)
{
    Style style;
    read_properties(node, style_rules, style, reading);
    object.fill = style.fill;
    if (style.stroke) {
        object.stroke = style.rest;
        object.stroke->colour = *style.stroke;
    }
    if (!has_property(node, "fill") && !has_property(node, "stroke"))
        reading.report.error(object.place, "this object would not be seen: it has neither fill nor stroke",
                             "add fill=COLOUR or stroke=COLOUR");
}

}
