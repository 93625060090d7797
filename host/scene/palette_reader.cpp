#include "host/scene/palette_reader.hpp"

#include "host/scene/limits.hpp"
#include "host/scene/node_form.hpp"
#include "host/scene/node_words.hpp"
#include "host/scene/property_rule.hpp"
#include "host/scene/value_reader.hpp"

namespace kfast::scene {
namespace {

constexpr NodeForm palette_form{"palette", "palette { NAME \"#rrggbb\" }", 0, 0, true};

/// `name` is what the scene calls its colour.
constexpr NodeForm colour_form(std::string_view name) { return {name, "NAME \"#rrggbb\"", 1, 1}; }

/// A palette knows basic and hexadecimal colours, not its own names.
std::optional<Colour> read_plain_colour(const kdl::Value& value, Reading& reading)
{
    static const Palette plain;
    const auto text = read_text(value, reading);
    const auto colour = text ? plain.find(std::string{*text}) : std::nullopt;
    if (text && !colour)
        report_unknown_colour(value, *text, plain, reading);
    return colour;
}

void read_named_colour(const kdl::Node& node, Reading& reading)
{
    if (!fits(node, colour_form(node.name), reading) || !refuse_properties(node, reading))
        return;
    // A wrong colour does not make every use of its name wrong as well.
    const Colour colour = read_plain_colour(node.arguments.front(), reading).value_or(Colour{});
    if (reading.palette.declared() == most_colours) {
        reading.report.error(node.name_place,
                             "a palette holds at most " + std::to_string(most_colours) + " colours");
        return;
    }
    if (const auto earlier = reading.palette.declare(node.name, colour, node.name_place))
        report_double("a colour", node.name, node.name_place, *earlier, reading.report);
}

}

void read_palette(const kdl::Node& node, Reading& reading)
{
    if (!fits(node, palette_form, reading) || !refuse_properties(node, reading))
        return;
    for (const kdl::Node& colour : node.children)
        if (!reading.report.full())
            read_named_colour(colour, reading);
}

std::vector<NodeWords> palette_words()
{
    constexpr std::string_view colour = "colour of palette";
    return {{palette_form.name, palette_form, {}, {}, {colour}},
            {colour, colour_form("NAME"), {any_colour}, {}, {}, true}};
}

}
