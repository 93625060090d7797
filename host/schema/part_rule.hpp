#pragma once

#include "host/schema/node_form.hpp"
#include "host/schema/report.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace kfast::schema {

/// How often a part may stand in a node.
enum class Times : std::uint8_t { once, at_most_once, any };

/// A node that may stand in another one. The table of them says what there may be, what it does, and what a
/// misspelt name is compared with.
template <class Target, class Context = Report>
struct PartRule {
    NodeForm form;
    /// Whether the node was good; reports it if not.
    bool (*read)(const kdl::Node& node, Target& target, Context& context) = nullptr;
    Times times = Times::once;
};

/// Whether `part` may stand in `whole` as often as it does; reports it if not.
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

}
