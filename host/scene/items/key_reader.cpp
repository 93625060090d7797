#include "host/scene/items/key_reader.hpp"

#include "host/scene/items/drawing_reader.hpp"
#include "host/scene/values/dash_reader.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/schema/node_form.hpp"
#include "host/schema/property_rule.hpp"
#include "host/text/characters.hpp"
#include "host/words/synonyms.hpp"

#include <algorithm>
#include <vector>

namespace kfast::scene {
namespace {

constexpr NodeForm drawing_key_form{key_name, "key TIME law=LAW { shapes }", 1, 1, true};
constexpr NodeForm group_key_form{key_name, "key TIME law=LAW x=X …", 1, 1};

constexpr std::array matches{Word<Match>{match_name(Match::count), Match::count},
                             Word<Match>{match_name(Match::length), Match::length},
                             Word<Match>{match_name(Match::letters), Match::letters}};

bool read_match(const kdl::Value& value, ItemKey& key, SceneContext& context)
{
    return assign(read_word(value, matches, context.report), key.match);
}

constexpr std::array match_rules{PropertyRule<ItemKey>{"match", read_match, ValueKind::one_of<matches>()}};
constexpr std::array paint_rules{
    PropertyRule<ItemKey>{"fill", read_own_value<Property::fill>, kind_of(Property::fill)},
    PropertyRule<ItemKey>{"stroke", read_own_value<Property::stroke>, kind_of(Property::stroke)},
    PropertyRule<ItemKey>{"width", read_own_value<Property::width>, kind_of(Property::width)},
};

constexpr auto symbol_key_rules = joined(law_rules<ItemKey>, match_rules);
constexpr auto group_key_rules = joined(law_rules<ItemKey>, place_rules<ItemKey>, show_rules<ItemKey>);
constexpr auto object_key_rules =
    joined(group_key_rules, match_rules, paint_rules, trim_rules<ItemKey>, dash_rules<ItemKey>);

bool read_key_properties(const kdl::Node& node, KeyHolder holder, ItemKey& key, SceneContext& context)
{
    switch (holder) {
    case KeyHolder::object:
        return read_properties(node, object_key_rules, key, context);
    case KeyHolder::group:
        return read_properties(node, group_key_rules, key, context);
    case KeyHolder::symbol:
        return read_properties(node, symbol_key_rules, key, context);
    }
    return false;
}

/// Whether it sets a value: laws and matches say how and not what.
bool is_setting(const kdl::Property& property)
{
    return std::ranges::find(symbol_key_rules, property.name, &PropertyRule<ItemKey>::name) ==
           symbol_key_rules.end();
}

bool report_idle_key(const ItemKey& key, KeyHolder holder, SceneContext& context)
{
    constexpr auto message = "this key sets nothing";
    switch (holder) {
    case KeyHolder::object:
        return context.report.error(key.place, message, "add shapes, \"empty\", or a property such as x=10");
    case KeyHolder::group:
        return context.report.error(key.place, message, "add a property such as x=10");
    case KeyHolder::symbol:
        return context.report.error(key.place, message, "add shapes or \"empty\"");
    }
    return false;
}

bool is_skeleton(const kdl::Node& node) { return node.name == skeleton_name; }

/// The names of the nodes that a key with a drawing may hold.
std::vector<std::string_view> names_inside(KeyHolder holder)
{
    std::vector<std::string_view> names = drawn_names();
    if (holder == KeyHolder::object)
        names.push_back(skeleton_name);
    return names;
}

void report_unknown(const kdl::Node& node, KeyHolder holder, SceneContext& context)
{
    context.report.error(node.name_span, "a key has no node " + in_quotes(node.name),
                         word_hint(node.name, names_inside(holder)));
}

void read_drawing(const kdl::Node& node, KeyHolder holder, ItemKey& key, SceneContext& context)
{
    DrawingReader drawing{context};
    for (const kdl::Node& child : node.children) {
        if (context.report.full())
            break;
        if (is_drawn(child.name))
            drawing.read(child);
        else if (!is_skeleton(child))
            report_unknown(child, holder, context);
    }
    take_points(1, node.name_span, context);
    key.drawing = drawing.take();
    key.depths = drawing.take_depths();
    key.sectors = drawing.take_sectors();
    key.letters = drawing.take_letters();
}

const kdl::Node* find_skeleton(const kdl::Node& key, KeyHolder holder, SceneContext& context)
{
    const auto skeleton = std::ranges::find_if(key.children, is_skeleton);
    if (skeleton == key.children.end())
        return nullptr;
    if (holder == KeyHolder::symbol)
        context.report.error(skeleton->name_span, "the key of a symbol has no skeleton",
                             "put it into a key of the object that uses the symbol");
    const auto second = std::find_if(skeleton + 1, key.children.end(), is_skeleton);
    if (second != key.children.end())
        context.report.error(second->name_span, "this key has a skeleton already",
                             "put all backbones into one skeleton");
    return &*skeleton;
}

}

bool holds_drawing(const kdl::Node& key) { return !std::ranges::all_of(key.children, is_skeleton); }

std::optional<ItemKey> read_key(const kdl::Node& node, KeyHolder holder, const KeyDriver& driver,
                                SceneContext& context)
{
    if (!fits(node, holder == KeyHolder::group ? group_key_form : drawing_key_form, context.report))
        return std::nullopt;
    const kdl::Value& moment = node.arguments.front();
    ItemKey key;
    key.node = &node;
    key.place = span(node.name_span, moment.place);
    read_key_properties(node, holder, key, context);
    key.skeleton = find_skeleton(node, holder, context);
    if (holds_drawing(node))
        read_drawing(node, holder, key, context);
    else if (key.skeleton == nullptr && std::ranges::none_of(node.properties, is_setting))
        report_idle_key(key, holder, context);
    const auto time = driver.read_moment(moment, context);
    if (!time)
        return std::nullopt;
    key.time = *time;
    return key;
}

std::vector<NodeSchema> key_schema()
{
    return {{key_name,
             drawing_key_form,
             {any_moment},
             schema_of(object_key_rules),
             drawn_ids(names_inside(KeyHolder::object))},
            {group_key_id, group_key_form, {any_moment}, schema_of(group_key_rules)},
            {symbol_key_id,
             drawing_key_form,
             {any_time},
             schema_of(symbol_key_rules),
             drawn_ids(names_inside(KeyHolder::symbol))}};
}

}
