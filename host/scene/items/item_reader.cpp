#include "host/scene/items/item_reader.hpp"

#include "host/kdl/document.hpp"
#include "host/scene/context/limits.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/items/copies.hpp"
#include "host/scene/items/key_list.hpp"
#include "host/scene/items/object_reader.hpp"
#include "host/scene/items/symbol_use.hpp"
#include "host/scene/items/track_builder.hpp"
#include "host/scene/items/track_reader.hpp"
#include "host/scene/model.hpp"
#include "host/scene/values/item_values.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/schema/node_form.hpp"
#include "host/schema/property_rule.hpp"
#include "host/text/characters.hpp"
#include "host/words/synonyms.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

namespace kfast::scene {

namespace {

constexpr std::array names_in_use{key_name, track_name};

/// How a use changes over time.
struct Changes {
    std::vector<ItemKey> keys;
    std::vector<TimedQuantity> timed;
};

Changes read_changes(const kdl::Node& node, const KeyDriver& driver, SceneContext& context)
{
    Changes changes;
    KeyList keys{KeyHolder::group, driver, context};
    for (const kdl::Node& child : node.children) {
        if (context.report.full())
            break;
        if (child.name == key_name) {
            keys.read(child);
        } else if (child.name == track_name) {
            if (auto quantity = read_track(child, KeyHolder::group, context))
                changes.timed.push_back(std::move(*quantity));
        } else {
            context.report.error(child.name_span, "a use has no node " + in_quotes(child.name),
                                 word_hint(child.name, names_in_use));
        }
    }
    changes.keys = keys.take();
    return changes;
}

/// A symbol of items, used as an item: its Use has the number of the symbol's entry in `context.symbols`.
/// Nothing when it cannot be used; what is wrong is reported. `depth` groups and uses are around it.
std::optional<Item> read_use(const kdl::Node& node, int depth, SceneContext& context)
{
    auto use = read_items_use(node, context);
    auto [keys, timed] = read_changes(node, use ? use->driver : KeyDriver{}, context);
    if (!use)
        return std::nullopt;
    const SourceSpan place = span(node.name_span, node.arguments.front().place);
    const bool is_repeated = use->repeat.count.has_value();
    if (depth + (is_repeated ? 2 : 1) + use->symbol->depth > deepest_item) {
        context.report.error(place, too_deep());
        return std::nullopt;
    }
    warn_of_idle_input(node, !keys.empty(), context);
    refuse_duplicate_quantities(timed, use->values, keys, context);
    mirror(use->mirror, use->values, keys, timed);
    auto tracks = build_tracks(node, use->values, {keys, use->driver.driver(), is_repeated}, timed, context);
    Item item{"", std::move(tracks), Use{context.symbols.number(*use->symbol), use->inner}, place,
              take_path(timed)};
    if (is_repeated)
        item.content = copies_of(node, *use, place, context);
    return item;
}

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

namespace {

constexpr NodeForm group_form{group_name, "group NAME { items }", 0, 1, true};

struct GroupProperties {
    ItemValues values;
    KeyDriver driver;
};

constexpr auto group_rules =
    joined(place_rules<GroupProperties>, show_rules<GroupProperties>, pivot_rules<GroupProperties>,
           std::array{PropertyRule<GroupProperties>{"input", read_own_driver<GroupProperties>, any_name}});

std::string read_group_name(const kdl::Node& node, SceneContext& context)
{
    if (node.arguments.empty())
        return {};
    return std::string{read_name(node.arguments.front(), context.report).value_or("")};
}

/// The names of the nodes that a group may hold.
std::vector<std::string_view> names_inside()
{
    std::vector<std::string_view> inside{item_names().begin(), item_names().end()};
    inside.push_back(key_name);
    inside.push_back(track_name);
    return inside;
}

void report_unknown(const kdl::Node& node, SceneContext& context)
{
    context.report.error(node.name_span, "a group has no node " + in_quotes(node.name),
                         word_hint(node.name, names_inside()));
}

/// The content of a group.
struct GroupContent {
    Group group;
    KeyList keys;
    std::vector<TimedQuantity> timed;
};

void read_timed(const kdl::Node& node, GroupContent& content, SceneContext& context)
{
    if (auto quantity = read_track(node, KeyHolder::group, context))
        content.timed.push_back(std::move(*quantity));
}

void read_inside(const kdl::Node& node, int depth, GroupContent& content, SceneContext& context)
{
    if (is_item(node.name))
        read_item(node, depth, content.group.items, context);
    else if (node.name == key_name)
        content.keys.read(node);
    else if (node.name == track_name)
        read_timed(node, content, context);
    else
        report_unknown(node, context);
}

bool is_change(const kdl::Node& node) { return node.name == key_name || node.name == track_name; }

}

std::optional<Item> read_group(const kdl::Node& node, int depth, SceneContext& context)
{
    if (!fits(node, group_form, context.report))
        return std::nullopt;
    const SourceSpan place =
        node.arguments.empty() ? node.name_span : span(node.name_span, node.arguments.front().place);
    if (depth == deepest_item) {
        context.report.error(place, too_deep());
        return std::nullopt;
    }
    GroupProperties properties;
    read_properties(node, group_rules, properties, context);
    GroupContent content{{}, {KeyHolder::group, properties.driver, context}, {}};
    for (const kdl::Node& child : node.children)
        if (!context.report.full())
            read_inside(child, depth + 1, content, context);
    refuse_crowded_order(content.group.items, context);
    if (std::ranges::all_of(node.children, is_change))
        context.report.error(place, "this group holds nothing", "add { object NAME … }");
    const std::vector<ItemKey> keys = content.keys.take();
    warn_of_idle_input(node, !keys.empty(), context);
    refuse_duplicate_quantities(content.timed, properties.values, keys, context);
    auto tracks =
        build_tracks(node, properties.values, {keys, properties.driver.driver()}, content.timed, context);
    return Item{read_group_name(node, context), std::move(tracks), std::move(content.group), place,
                take_path(content.timed)};
}

NodeSchema group_schema()
{
    auto inside = names_inside();
    std::ranges::replace(inside, key_name, group_key_id);
    return {group_form.name, group_form, {any_name}, schema_of(group_rules), inside};
}

}
