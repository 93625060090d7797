#include "host/scene/item_reader.hpp"

#include "host/scene/group_reader.hpp"
#include "host/scene/limits.hpp"
#include "host/scene/object_reader.hpp"
#include "host/scene/symbol_use.hpp"
#include "host/scene/use_reader.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

namespace kfast::scene {
namespace {

constexpr std::array names{object_name, group_name, use_name};

std::optional<Item> read_item(const kdl::Node& node, int depth, Reading& reading)
{
    if (node.name == object_name)
        return read_object(node, reading);
    return node.name == group_name ? read_group(node, depth, reading) : read_use(node, depth, reading);
}

bool has_order(const Item& item)
{
    return std::ranges::find(item.tracks, Property::order, &Track::property) != item.tracks.end();
}

}

std::span<const std::string_view> item_names() { return names; }

bool is_item(std::string_view name) { return std::ranges::find(names, name) != names.end(); }

void read_item(const kdl::Node& node, int depth, std::vector<Item>& items, Reading& reading)
{
    if (auto item = read_item(node, depth, reading))
        items.push_back(std::move(*item));
}

void refuse_crowded_order(std::span<const Item> items, Reading& reading)
{
    const auto ordered = std::ranges::find_if(items, has_order);
    if (items.size() > most_ordered_items && ordered != items.end())
        reading.report.error(ordered->place,
                             "an item with an order lies among " + std::to_string(items.size()) +
                                 " items; the format holds " + std::to_string(most_ordered_items),
                             "put it into a group, together with those that it passes");
}

}
