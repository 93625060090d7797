#include "host/scene/property_rule.hpp"

#include "host/text/glyph.hpp"
#include "host/text/suggestion.hpp"

#include <string>

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

bool report_unknown_property(const kdl::Node& node, const kdl::Property& property,
                             std::span<const std::string_view> known, Reading& reading)
{
    return reading.report.error(property.name_place,
                                node.name + " has no property " + in_quotes(property.name),
                                suggestion(property.name, known));
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
