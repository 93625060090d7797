#include "host/schema/node_form.hpp"

namespace kfast::schema {

bool fits(const kdl::Node& node, const NodeForm& form, Report& report)
{
    const std::string name{form.name};
    const std::string remedy = "write " + std::string{form.usage};
    if (node.type)
        return report.error(node.name_place, "a node takes no type here", remedy);
    if (node.arguments.size() < form.least_values)
        return report.error(node.name_place, name + " needs more values", remedy);
    if (node.arguments.size() > form.most_values)
        return report.error(node.arguments[form.most_values].place, "this value is too many for " + name,
                            remedy);
    if (!form.takes_nodes && !node.children.empty())
        return report.error(node.children.front().name_place, name + " takes no nodes inside", remedy);
    return true;
}

}
