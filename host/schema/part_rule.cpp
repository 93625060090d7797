#include "host/schema/part_rule.hpp"

#include "host/text/glyph.hpp"
#include "host/text/suggestion.hpp"

#include <string>

namespace kfast::schema {
namespace {

std::string usage_remedy(const NodeForm& form) { return "write " + std::string{form.usage}; }

}

bool may_stand(const kdl::Node& part, const kdl::Node& whole, Times times, Report& report)
{
    const auto first = std::ranges::find(whole.children, part.name, &kdl::Node::name);
    if (times == Times::any || &*first == &part)
        return true;
    return report.error(part.name_place,
                        in_quotes(part.name) + " stands here already, on " + report.line(first->name_place));
}

void report_unknown_part(const kdl::Node& part, const kdl::Node& whole,
                         std::span<const std::string_view> known, Report& report)
{
    report.error(part.name_place, "a " + whole.name + " has no node " + in_quotes(part.name),
                 suggestion(part.name, known));
}

void require_part(const NodeForm& form, const kdl::Node& whole, Report& report)
{
    if (std::ranges::find(whole.children, form.name, &kdl::Node::name) == whole.children.end())
        report.error(whole.name_place, "this " + whole.name + " has no " + std::string{form.name},
                     "add \"" + std::string{form.usage} + '"');
}

const kdl::Node* only_node(const kdl::Document& document, const NodeForm& form, std::string_view what,
                           Report& report)
{
    if (document.nodes.empty()) {
        report.error(Place{}, "there is no " + std::string{form.name} + " in this text", usage_remedy(form));
        return nullptr;
    }
    const kdl::Node& first = document.nodes.front();
    const bool begins_right = first.name == form.name;
    if (begins_right && document.nodes.size() == 1)
        return &first;
    report.error(begins_right ? document.nodes[1].name_place : first.name_place,
                 std::string{what} + " is one node", usage_remedy(form));
    return nullptr;
}

}
