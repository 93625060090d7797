#include "host/schema/property_rule.hpp"

#include "host/text/characters.hpp"
#include "host/words/synonyms.hpp"

#include <iterator>
#include <string>
#include <vector>

namespace kfast::schema {

bool has_property(const kdl::Node& node, std::string_view name)
{
    return std::ranges::find(node.properties, name, &kdl::Property::name) != node.properties.end();
}

SourceSpan property_span(const kdl::Node& node, std::string_view name)
{
    const auto property = std::ranges::find(node.properties, name, &kdl::Property::name);
    if (property == node.properties.end())
        return node.name_span;
    return span(property->name_span, property->value.place);
}

namespace {

std::string hint_of_property(const kdl::Node& node, const kdl::Property& property,
                             std::span<const std::string_view> known, const Report& report)
{
    std::string hint = report.property_hint(node, property, known);
    return hint.empty() ? word_hint(property.name, known) : hint;
}

}

bool report_unknown_property(const kdl::Node& node, const kdl::Property& property,
                             std::span<const std::string_view> known, Report& report)
{
    return report.error(property.name_span, node.name + " has no property " + in_quotes(property.name),
                        hint_of_property(node, property, known, report));
}

bool report_missing_property(const kdl::Node& node, std::string_view name, Report& report)
{
    const std::string property{name};
    return report.error(node.name_span, node.name + " needs the property \"" + property + '"',
                        "add " + property + "=…");
}

void warn_if_idle(const kdl::Node& node, const kdl::Property& property, std::string_view needs,
                  Report& report)
{
    if (needs.empty() || has_property(node, needs))
        return;
    report.warning(span(property.name_span, property.value.place),
                   property.name + " does nothing without a " + std::string{needs},
                   "add " + std::string{needs} + "=… or remove " + property.name);
}

bool refuse_properties(const kdl::Node& node, Report& report)
{
    return node.properties.empty() || report_unknown_property(node, node.properties.front(), {}, report);
}

}
