#include "host/scene/values/palette_reader.hpp"

#include "host/scene/context/limits.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/schema/node_form.hpp"
#include "host/schema/node_schema.hpp"
#include "host/schema/property_rule.hpp"

namespace kfast::scene {
namespace {

constexpr NodeForm palette_form{"palette", "palette { NAME \"#rrggbb\" }", 0, 0, true};

/// `name` is what the scene calls its colour.
constexpr NodeForm colour_form(std::string_view name) { return {name, "NAME \"#rrggbb\"", 1, 1}; }

/// A palette knows basic and hexadecimal colours, not its own names.
std::optional<Colour> read_plain_colour(const kdl::Value& value, SceneContext& context)
{
    static const Palette plain;
    const auto text = read_text(value, context.report);
    const auto colour = text ? plain.find(std::string{*text}) : std::nullopt;
    if (text && !colour)
        report_unknown_colour(value, *text, plain, context);
    return colour;
}

void read_named_colour(const kdl::Node& node, SceneContext& context)
{
    if (!fits(node, colour_form(node.name), context.report) || !refuse_properties(node, context.report))
        return;
    // A wrong colour does not make every use of its name wrong as well.
    const Colour colour = read_plain_colour(node.arguments.front(), context).value_or(Colour{});
    if (context.palette.declared() == max_colours) {
        context.report.error(node.name_span,
                             "a palette holds at most " + std::to_string(max_colours) + " colours");
        return;
    }
    if (const auto earlier = context.palette.declare(node.name, colour, node.name_span))
        report_duplicate("a colour", node.name, node.name_span, *earlier, context.report);
}

}

void read_palette(const kdl::Node& node, SceneContext& context)
{
    if (!fits(node, palette_form, context.report) || !refuse_properties(node, context.report))
        return;
    for (const kdl::Node& colour : node.children)
        if (!context.report.full())
            read_named_colour(colour, context);
}

std::vector<NodeSchema> palette_words()
{
    constexpr std::string_view colour = "colour of palette";
    return {{palette_form.name, palette_form, {}, {}, {colour}},
            {colour, colour_form("NAME"), {any_colour}, {}, {}, true}};
}

}
