#include "host/schema/node_form.hpp"

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

}
