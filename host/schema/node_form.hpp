#pragma once

#include "host/kdl/document.hpp"
#include "host/schema/property_rule.hpp"
#include "host/schema/report.hpp"
#include "host/schema/value_kind.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace kfast::schema {

/// What a kind of node looks like, apart from its properties.
struct NodeForm {
    std::string_view name;
    std::string_view usage; ///< shown where a node does not fit
    std::size_t min_values = 0;
    std::size_t max_values = 0;
    bool takes_nodes = false;

    static constexpr std::size_t any_number = std::numeric_limits<std::size_t>::max();
};

/// Whether `node` fits its form; reports what does not.
bool fits(const kdl::Node& node, const NodeForm& form, Report& report);

/// How often a part may occur in a node.
enum class Times : std::uint8_t { once, at_most_once, any };

/// A node that another one may contain. The table of them says what is allowed, what it does, and what a
/// misspelt name is compared with.
template <class Target, class Context = Report>
struct PartRule {
    NodeForm form;
    /// Returns whether the node was valid; reports it if not.
    bool (*read)(const kdl::Node& node, Target& target, Context& context) = nullptr;
    Times times = Times::once;
};

/// Whether `part` may occur in `whole` as often as it does; reports it if not.
bool may_stand(const kdl::Node& part, const kdl::Node& whole, Times times, Report& report);
void report_unknown_part(const kdl::Node& part, const kdl::Node& whole,
                         std::span<const std::string_view> known, Report& report);
/// Reports if `whole` has no node of that form.
void require_part(const NodeForm& form, const kdl::Node& whole, Report& report);

/// Reads the nodes inside `whole`, in their order.
template <class Target, class Context, std::size_t count>
void read_parts(const kdl::Node& whole, const std::array<PartRule<Target, Context>, count>& rules,
                Target& target, Context& context)
{
    Report& report = report_of(context);
    std::array<std::string_view, count> known;
    std::ranges::transform(rules, known.begin(), [](const auto& rule) { return rule.form.name; });
    for (const kdl::Node& part : whole.children) {
        const auto rule = std::ranges::find(rules, part.name, [](const auto& r) { return r.form.name; });
        if (rule == rules.end())
            report_unknown_part(part, whole, known, report);
        else if (may_stand(part, whole, rule->times, report) && fits(part, rule->form, report))
            rule->read(part, target, context);
    }
    for (const auto& rule : rules)
        if (rule.times == Times::once)
            require_part(rule.form, whole, report);
}

/// The only node of a text that holds nothing but `what` ("a description of a board"); reports if there is
/// another or none, and then returns null.
const kdl::Node* only_node(const kdl::Document& document, const NodeForm& form, std::string_view what,
                           Report& report);

/// The description of a property, from its rule.
struct PropertySchema {
    std::string_view name;
    ValueKind kind;
    bool required = false;
    std::string_view needs = {}; ///< another property, without which this one does nothing
};

/// The description of a node in a certain context, from its reader.
struct NodeSchema {
    /// Its name; where nodes of one name differ by their parent, "NAME of PARENT". Several entries of one id
    /// are several ways to write such a node.
    std::string_view id;
    NodeForm form;                      ///< its name represents any name if `takes_any_name`
    std::vector<ValueKind> values = {}; ///< the last applies to all that follow
    std::vector<PropertySchema> properties = {};
    std::vector<std::string_view> inside = {}; ///< ids of the nodes that it may hold
    bool takes_any_name = false;               ///< the name of a colour or a bone of the scene
    /// Of properties whose names are the scene's own, if it takes such.
    std::optional<ValueKind> any_property = {};
};

template <class Target, class Context, std::size_t count>
std::vector<PropertySchema> schema_of(const std::array<PropertyRule<Target, Context>, count>& rules)
{
    std::vector<PropertySchema> words;
    words.reserve(count);
    for (const auto& rule : rules)
        words.push_back({rule.name, rule.kind, rule.required, rule.needs});
    return words;
}

}
