#include "host/scene_text/items/item_text.hpp"

#include "host/scene_text/items/object_text.hpp"
#include "host/scene_text/items/track_text.hpp"
#include "host/scene_text/values/nodes.hpp"
#include "host/scene_text/values/visible_keys.hpp"

#include <iterator>

namespace kfast::scene_text {
namespace {

void add_visibility(kdl::Node& item, const art::Node& node, const Writing& writing)
{
    const auto keys = visible_keys(node.shown, writing.length);
    if (keys.size() == 1)
        return;
    for (const auto& key : keys) {
        kdl::Node moment = named_node("key", number(key.ticks, times));
        set(moment, "visible", truth(key.value));
        item.children.push_back(std::move(moment));
    }
}

kdl::Node group_node(const art::Node& node, Writing& writing)
{
    kdl::Node group = named_node("group");
    if (const std::string name = clean_name(node.name, ""); !name.empty())
        group.arguments.push_back(text(name));
    add_transform(group, node.transform, node.opacity, {}, writing);
    add_visibility(group, node, writing);
    std::vector<kdl::Node> items = item_nodes(std::get<art::Group>(node.content).nodes, writing);
    std::ranges::move(items, std::back_inserter(group.children));
    return group;
}

}

std::vector<kdl::Node> item_nodes(const std::vector<art::Node>& nodes, Writing& writing)
{
    std::vector<kdl::Node> items;
    items.reserve(nodes.size());
    for (const art::Node& node : nodes)
        items.push_back(std::holds_alternative<art::Shape>(node.content) ? object_node(node, writing)
                                                                         : group_node(node, writing));
    return items;
}

}
