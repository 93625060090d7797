#include "host/scene/items/item_reader.hpp"

#include "host/scene/context/limits.hpp"
#include "host/scene/items/group_reader.hpp"
#include "host/scene/items/object_reader.hpp"
#include "host/scene/items/symbol_use.hpp"
#include "host/scene/items/use_reader.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

namespace kfast::scene {
namespace {

constexpr std::array names{object_name, group_name, use_name};

std::optional<Item> read_item(const kdl::Node& node, int depth, SceneContext& context)
{
    if (node.name == object_name)
        return read_object(node, context);
    return node.name == group_name ? read_group(node, depth, context) : read_use(node, depth, context);
}

bool has_order(const Item& item)
{
    return std::ranges::find(item.tracks, Property::order, &Track::property) != item.tracks.end();
}

}

std::span<const std::string_view> item_names() { return names; }

bool is_item(std::string_view name) { return std::ranges::find(names, name) != names.end(); }

void read_item(const kdl::Node& node, int depth, std::vector<Item>& items, SceneContext& context)
{
    if (auto item = read_item(node, depth, context))
        items.push_back(std::move(*item));
}

void refuse_crowded_order(std::span<const Item> items, SceneContext& context)
{
    const auto ordered = std::ranges::find_if(items, has_order);
    if (items.size() > max_ordered_items && ordered != items.end())
        context.report.error(ordered->place,
                             "an item with an order lies among " + std::to_string(items.size()) +
                                 " items; the format holds " + std::to_string(max_ordered_items),
                             "put it into a group, together with those that it passes");
}

}
