#include "host/scene/property_rule.hpp"

#include "host/scene/node_words.hpp"
#include "host/scene/object_properties.hpp"
#include "host/scene/shape_reader.hpp"
#include "host/scene/synonyms.hpp"
#include "host/scene/wire_reader.hpp"
#include "host/text/glyph.hpp"

#include <iterator>
#include <string>
#include <vector>

namespace kfast::scene {

bool has_property(const kdl::Node& node, std::string_view name)
{
    return std::ranges::find(node.properties, name, &kdl::Property::name) != node.properties.end();
}

Place property_place(const kdl::Node& node, std::string_view name)
{
    const auto property = std::ranges::find(node.properties, name, &kdl::Property::name);
    if (property == node.properties.end())
        return node.name_place;
    return span(property->name_place, property->value.place);
}

namespace {

/// What of an object stands at one of its shapes, which is a common mistake.
std::string_view property_of_object(const kdl::Node& node, const kdl::Property& property)
{
    static const auto names = [] {
        std::vector<std::string_view> list;
        std::ranges::transform(object_property_words(), std::back_inserter(list), &PropertyWords::name);
        return list;
    }();
    return is_shape(node.name) || is_wire(node.name) ? meaning_among(names, property.name)
                                                     : std::string_view{};
}

std::string remedy_of_property(const kdl::Node& node, const kdl::Property& property,
                               std::span<const std::string_view> known)
{
    const std::string_view of_object = property_of_object(node, property);
    if (of_object.empty() || !meaning_among(known, property.name).empty())
        return word_remedy(property.name, known);
    return "objects have it: object NAME " + std::string{of_object} + "=…";
}

}

bool report_unknown_property(const kdl::Node& node, const kdl::Property& property,
                             std::span<const std::string_view> known, Reading& reading)
{
    return reading.report.error(property.name_place,
                                node.name + " has no property " + in_quotes(property.name),
                                remedy_of_property(node, property, known));
}

bool report_missing_property(const kdl::Node& node, std::string_view name, Reading& reading)
{
    const std::string property{name};
    return reading.report.error(node.name_place, node.name + " needs the property \"" + property + '"',
                                "add " + property + "=…");
}

void warn_if_idle(const kdl::Node& node, const kdl::Property& property, std::string_view needs,
                  Reading& reading)
{
    if (needs.empty() || has_property(node, needs))
        return;
    reading.report.warning(span(property.name_place, property.value.place),
                           property.name + " does nothing without a " + std::string{needs},
                           "add " + std::string{needs} + "=… or remove " + property.name);
}

bool refuse_properties(const kdl::Node& node, Reading& reading)
{
    return node.properties.empty() || report_unknown_property(node, node.properties.front(), {}, reading);
}

}
