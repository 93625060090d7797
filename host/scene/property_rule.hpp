#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/reading.hpp"
#include "host/scene/value_kind.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string_view>

namespace kfast::scene {

/// A property of a kind of node. The table of them says what may be written, what it does, and what a
/// misspelt name is compared with.
template <class Target>
struct PropertyRule {
    std::string_view name = {};
    /// Whether the value was good; reports it if not.
    bool (*read)(const kdl::Value& value, Target& target, Reading& reading) = nullptr;
    ValueKind kind = {}; ///< of the values that `read` takes
    bool required = false;
    std::string_view needs = {}; ///< another property, without which this one does nothing
};

/// The rules of several tables in one.
template <class Target, std::size_t... counts>
constexpr auto joined(const std::array<PropertyRule<Target>, counts>&... tables)
{
    std::array<PropertyRule<Target>, (counts + ...)> all{};
    auto end = all.begin();
    ((end = std::ranges::copy(tables, end).out), ...);
    return all;
}

bool has_property(const kdl::Node& node, std::string_view name);
/// From the name to the end of the value; the node's own name when it has no such property.
Place property_place(const kdl::Node& node, std::string_view name);
bool report_unknown_property(const kdl::Node& node, const kdl::Property& property,
                             std::span<const std::string_view> known, Reading& reading);
bool report_missing_property(const kdl::Node& node, std::string_view name, Reading& reading);
void warn_if_idle(const kdl::Node& node, const kdl::Property& property, std::string_view needs,
                  Reading& reading);

template <class Target, std::size_t count>
bool read_property(const kdl::Node& node, const kdl::Property& property,
                   const std::array<PropertyRule<Target>, count>& rules, Target& target, Reading& reading)
{
    const auto rule = std::ranges::find(rules, property.name, &PropertyRule<Target>::name);
    if (rule != rules.end()) {
        warn_if_idle(node, property, rule->needs, reading);
        return rule->read(property.value, target, reading);
    }
    std::array<std::string_view, count> known;
    std::ranges::transform(rules, known.begin(), &PropertyRule<Target>::name);
    return report_unknown_property(node, property, known, reading);
}

/// Whether all properties of `node` were good, and none is missing.
template <class Target, std::size_t count>
bool read_properties(const kdl::Node& node, const std::array<PropertyRule<Target>, count>& rules,
                     Target& target, Reading& reading)
{
    bool good = true;
    for (const kdl::Property& property : node.properties)
        good = !reading.report.full() && read_property(node, property, rules, target, reading) && good;
    for (const PropertyRule<Target>& rule : rules)
        if (rule.required && !has_property(node, rule.name))
            good = report_missing_property(node, rule.name, reading);
    return good;
}

/// For nodes that have none.
bool refuse_properties(const kdl::Node& node, Reading& reading);

}
