#pragma once

#include "host/kdl/document.hpp"
#include "host/schema/report.hpp"
#include "host/schema/value_kind.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string_view>

namespace kfast::schema {

/// A property of a kind of node. The table of them says what may be written, what it does, and what a
/// misspelt name is compared with.
///
/// `Context` is what else is known while a text is read, with a report_of() that has the report.
template <class Target, class Context = Report>
struct PropertyRule {
    std::string_view name = {};
    /// Returns whether the value was valid; reports it if not.
    bool (*read)(const kdl::Value& value, Target& target, Context& context) = nullptr;
    ValueKind kind = {}; ///< of the values that `read` takes
    bool required = false;
    std::string_view needs = {}; ///< another property, without which this one does nothing
};

/// The rules of several tables in one.
template <class Target, class Context, std::size_t... counts>
constexpr auto joined(const std::array<PropertyRule<Target, Context>, counts>&... tables)
{
    std::array<PropertyRule<Target, Context>, (counts + ...)> all{};
    auto end = all.begin();
    ((end = std::ranges::copy(tables, end).out), ...);
    return all;
}

bool has_property(const kdl::Node& node, std::string_view name);
/// From the name to the end of the value; the node's own name when it has no such property.
SourceSpan property_span(const kdl::Node& node, std::string_view name);
bool report_unknown_property(const kdl::Node& node, const kdl::Property& property,
                             std::span<const std::string_view> known, Report& report);
bool report_missing_property(const kdl::Node& node, std::string_view name, Report& report);
void warn_if_idle(const kdl::Node& node, const kdl::Property& property, std::string_view needs,
                  Report& report);

template <class Target, class Context, std::size_t count>
bool read_property(const kdl::Node& node, const kdl::Property& property,
                   const std::array<PropertyRule<Target, Context>, count>& rules, Target& target,
                   Context& context)
{
    using Rule = PropertyRule<Target, Context>;
    const auto rule = std::ranges::find(rules, property.name, &Rule::name);
    if (rule != rules.end()) {
        warn_if_idle(node, property, rule->needs, report_of(context));
        return rule->read(property.value, target, context);
    }
    std::array<std::string_view, count> known;
    std::ranges::transform(rules, known.begin(), &Rule::name);
    return report_unknown_property(node, property, known, report_of(context));
}

/// Reads all properties of `node`; returns whether all are valid, and none is missing.
template <class Target, class Context, std::size_t count>
bool read_properties(const kdl::Node& node, const std::array<PropertyRule<Target, Context>, count>& rules,
                     Target& target, Context& context)
{
    bool good = true;
    Report& report = report_of(context);
    for (const kdl::Property& property : node.properties)
        good = !report.full() && read_property(node, property, rules, target, context) && good;
    for (const auto& rule : rules)
        if (rule.required && !has_property(node, rule.name))
            good = report_missing_property(node, rule.name, report);
    return good;
}

/// For nodes that have no properties.
bool refuse_properties(const kdl::Node& node, Report& report);

}
