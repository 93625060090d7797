#include "host/scene/items/group_reader.hpp"

#include "host/scene/context/limits.hpp"
#include "host/scene/items/duplicate_quantity.hpp"
#include "host/scene/items/item_reader.hpp"
#include "host/scene/items/key_list.hpp"
#include "host/scene/items/track_builder.hpp"
#include "host/scene/items/track_reader.hpp"
#include "host/scene/values/item_values.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/schema/node_form.hpp"
#include "host/schema/node_schema.hpp"
#include "host/schema/property_rule.hpp"
#include "host/text/glyph.hpp"
#include "host/words/synonyms.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace kfast::scene {
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

/// Of nodes that a group may hold.
std::vector<std::string_view> names_inside()
{
    std::vector<std::string_view> names{item_names().begin(), item_names().end()};
    names.push_back(key_name);
    names.push_back(track_name);
    return names;
}

void report_unknown(const kdl::Node& node, SceneContext& context)
{
    context.report.error(node.name_span, "a group has no node " + in_quotes(node.name),
                         word_hint(node.name, names_inside()));
}

/// What stands inside of a group.
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

NodeSchema group_words()
{
    auto inside = names_inside();
    std::ranges::replace(inside, key_name, group_key_id);
    return {group_form.name, group_form, {any_name}, words_of(group_rules), inside};
}

}
