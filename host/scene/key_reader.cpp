#include "host/scene/key_reader.hpp"

#include "host/scene/drawing_reader.hpp"
#include "host/scene/node_form.hpp"
#include "host/scene/property_rule.hpp"
#include "host/scene/shape_reader.hpp"
#include "host/scene/value_reader.hpp"
#include "host/text/glyph.hpp"

namespace kfast::scene {
namespace {

constexpr NodeForm key_form{key_name, "key TIME law=LAW { shapes }", 1, 1, true};

constexpr std::array laws{
    Word<VelocityLaw>{"constant", VelocityLaw::constant},
    Word<VelocityLaw>{"accelerate", VelocityLaw::accelerate},
    Word<VelocityLaw>{"decelerate", VelocityLaw::decelerate},
    Word<VelocityLaw>{"accelerate-decelerate", VelocityLaw::accelerate_decelerate},
};

/// The law of one axis wins over that of both, whichever is written first.
struct Laws {
    std::optional<VelocityLaw> both;
    std::optional<VelocityLaw> x;
    std::optional<VelocityLaw> y;
};

template <std::optional<VelocityLaw> Laws::*member>
bool read_law(const kdl::Value& value, Laws& target, Reading& reading)
{
    return assign(read_word(value, laws, reading), target.*member);
}

constexpr std::array law_rules{
    PropertyRule<Laws>{"law", read_law<&Laws::both>},
    PropertyRule<Laws>{"law-x", read_law<&Laws::x>},
    PropertyRule<Laws>{"law-y", read_law<&Laws::y>},
};

Drawing read_drawing(const kdl::Node& key, Reading& reading)
{
    DrawingReader drawing{reading};
    for (const kdl::Node& node : key.children) {
        if (reading.report.full())
            break;
        if (is_shape(node.name))
            drawing.read(node);
        else
            reading.report.error(node.name_place, "a key has no node " + quoted(node.name),
                                 suggestion(node.name, shape_names()));
    }
    return drawing.take();
}

}

std::optional<Key> read_key(const kdl::Node& node, Reading& reading)
{
    if (!fits(node, key_form, reading))
        return std::nullopt;
    Laws chosen;
    read_properties(node, law_rules, chosen, reading);
    Drawing drawing = read_drawing(node, reading);
    const kdl::Value& moment = node.arguments.front();
    const auto time = read_time(moment, reading);
    if (!time)
        return std::nullopt;
    const VelocityLaw both = chosen.both.value_or(VelocityLaw::constant);
    return Key{.time = *time,
               .law_x = chosen.x.value_or(both),
               .law_y = chosen.y.value_or(both),
               .drawing = std::move(drawing),
               .place = span(node.name_place, moment.place)};
}

std::optional<Place> law_place(const kdl::Node& node)
{
    for (const kdl::Property& property : node.properties)
        if (std::ranges::find(law_rules, property.name, &PropertyRule<Laws>::name) != law_rules.end())
            return span(property.name_place, property.value.place);
    return std::nullopt;
}

}
