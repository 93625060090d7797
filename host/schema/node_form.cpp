#include "host/schema/node_form.hpp"

#include "host/text/characters.hpp"
#include "host/text/suggestion.hpp"

#include <string>

namespace kfast::schema {

bool fits(const kdl::Node& node, const NodeForm& form, Report& report)
{
    const std::string name{form.name};
    const std::string hint = "write " + std::string{form.usage};
    if (node.type)
        return report.error(node.name_span, "a node takes no type here", hint);
    if (node.arguments.size() < form.min_values)
        return report.error(node.name_span, name + " needs more values", hint);
    if (node.arguments.size() > form.max_values)
        return report.error(node.arguments[form.max_values].place, "this value is too many for " + name,
                            hint);
    if (!form.takes_nodes && !node.children.empty())
        return report.error(node.children.front().name_span, name + " takes no nodes inside", hint);
    return true;
}

namespace {

std::string usage_hint(const NodeForm& form) { return "write " + std::string{form.usage}; }

}

bool may_stand(const kdl::Node& part, const kdl::Node& whole, Times times, Report& report)
{
    const auto first = std::ranges::find(whole.children, part.name, &kdl::Node::name);
    if (times == Times::any || &*first == &part)
        return true;
    return report.error(part.name_span,
                        in_quotes(part.name) + " stands here already, on " + report.line(first->name_span));
}

void report_unknown_part(const kdl::Node& part, const kdl::Node& whole,
                         std::span<const std::string_view> known, Report& report)
{
    report.error(part.name_span, "a " + whole.name + " has no node " + in_quotes(part.name),
                 suggestion(part.name, known));
}

void require_part(const NodeForm& form, const kdl::Node& whole, Report& report)
{
    if (std::ranges::find(whole.children, form.name, &kdl::Node::name) == whole.children.end())
        report.error(whole.name_span, "this " + whole.name + " has no " + std::string{form.name},
                     "add \"" + std::string{form.usage} + '"');
}

const kdl::Node* only_node(const kdl::Document& document, const NodeForm& form, std::string_view what,
                           Report& report)
{
    if (document.nodes.empty()) {
        report.error(SourceSpan{}, "there is no " + std::string{form.name} + " in this text",
                     usage_hint(form));
        return nullptr;
    }
    const kdl::Node& first = document.nodes.front();
    const bool begins_right = first.name == form.name;
    if (begins_right && document.nodes.size() == 1)
        return &first;
    report.error(begins_right ? document.nodes[1].name_span : first.name_span,
                 std::string{what} + " is one node", usage_hint(form));
    return nullptr;
}

}
