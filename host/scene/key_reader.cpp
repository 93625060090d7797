#include "host/scene/key_reader.hpp"

#include "host/scene/drawing_reader.hpp"
#include "host/scene/node_form.hpp"
#include "host/scene/node_words.hpp"
#include "host/scene/property_rule.hpp"
#include "host/scene/synonyms.hpp"
#include "host/scene/value_reader.hpp"
#include "host/text/glyph.hpp"

#include <algorithm>
#include <vector>

namespace kfast::scene {
namespace {

constexpr NodeForm drawing_key_form{key_name, "key TIME law=LAW { shapes }", 1, 1, true};
constexpr NodeForm group_key_form{key_name, "key TIME law=LAW x=X …", 1, 1};

constexpr std::array matches{Word<Match>{"count", Match::count}, Word<Match>{"length", Match::length}};

bool read_match(const kdl::Value& value, ItemKey& key, Reading& reading)
{
    return assign(read_word(value, matches, reading), key.match);
}

constexpr std::array match_rules{PropertyRule<ItemKey>{"match", read_match, ValueKind::one_of<matches>()}};
constexpr std::array paint_rules{
    PropertyRule<ItemKey>{"fill", read_own_value<Property::fill>, kind_of(Property::fill)},
    PropertyRule<ItemKey>{"stroke", read_own_value<Property::stroke>, kind_of(Property::stroke)},
    PropertyRule<ItemKey>{"width", read_own_value<Property::width>, kind_of(Property::width)},
};

constexpr auto symbol_key_rules = joined(law_rules<ItemKey>, match_rules);
constexpr auto group_key_rules = joined(law_rules<ItemKey>, place_rules<ItemKey>, show_rules<ItemKey>);
constexpr auto object_key_rules = joined(group_key_rules, match_rules, paint_rules);

bool read_key_properties(const kdl::Node& node, KeyHolder holder, ItemKey& key, Reading& reading)
{
    switch (holder) {
    case KeyHolder::object:
        return read_properties(node, object_key_rules, key, reading);
    case KeyHolder::group:
        return read_properties(node, group_key_rules, key, reading);
    case KeyHolder::symbol:
        return read_properties(node, symbol_key_rules, key, reading);
    }
    return false;
}

/// Whether it is more than a law or a match, which say how and not what.
bool is_setting(const kdl::Property& property)
{
    return std::ranges::find(symbol_key_rules, property.name, &PropertyRule<ItemKey>::name) ==
           symbol_key_rules.end();
}

bool report_idle_key(const ItemKey& key, KeyHolder holder, Reading& reading)
{
    constexpr auto message = "this key sets nothing";
    switch (holder) {
    case KeyHolder::object:
        return reading.report.error(key.place, message, "add shapes, \"empty\", or a property such as x=10");
    case KeyHolder::group:
        return reading.report.error(key.place, message, "add a property such as x=10");
    case KeyHolder::symbol:
        return reading.report.error(key.place, message, "add shapes or \"empty\"");
    }
    return false;
}

bool is_skeleton(const kdl::Node& node) { return node.name == skeleton_name; }

/// Of nodes that a key with a drawing may hold.
std::vector<std::string_view> names_inside(KeyHolder holder)
{
    std::vector<std::string_view> names = drawn_names();
    if (holder == KeyHolder::object)
        names.push_back(skeleton_name);
    return names;
}

void report_unknown(const kdl::Node& node, KeyHolder holder, Reading& reading)
{
    reading.report.error(node.name_place, "a key has no node " + in_quotes(node.name),
                         word_remedy(node.name, names_inside(holder)));
}

void read_drawing(const kdl::Node& node, KeyHolder holder, ItemKey& key, Reading& reading)
{
    DrawingReader drawing{reading};
    for (const kdl::Node& child : node.children) {
        if (reading.report.full())
            break;
        if (is_drawn(child.name))
            drawing.read(child);
        else if (!is_skeleton(child))
            report_unknown(child, holder, reading);
    }
    take_points(1, node.name_place, reading);
    key.drawing = drawing.take();
    key.depths = drawing.take_depths();
    key.sectors = drawing.take_sectors();
}

const kdl::Node* find_skeleton(const kdl::Node& key, KeyHolder holder, Reading& reading)
{
    const auto skeleton = std::ranges::find_if(key.children, is_skeleton);
    if (skeleton == key.children.end())
        return nullptr;
    if (holder == KeyHolder::symbol)
        reading.report.error(skeleton->name_place, "the key of a symbol has no skeleton",
                             "put it into a key of the object that uses the symbol");
    const auto second = std::find_if(skeleton + 1, key.children.end(), is_skeleton);
    if (second != key.children.end())
        reading.report.error(second->name_place, "this key has a skeleton already",
                             "put all backbones into one skeleton");
    return &*skeleton;
}

}

bool holds_drawing(const kdl::Node& key) { return !std::ranges::all_of(key.children, is_skeleton); }

std::optional<ItemKey> read_key(const kdl::Node& node, KeyHolder holder, const KeyClock& clock,
                                Reading& reading)
{
    if (!fits(node, holder == KeyHolder::group ? group_key_form : drawing_key_form, reading))
        return std::nullopt;
    const kdl::Value& moment = node.arguments.front();
    ItemKey key;
    key.node = &node;
    key.place = span(node.name_place, moment.place);
    read_key_properties(node, holder, key, reading);
    key.skeleton = find_skeleton(node, holder, reading);
    if (holds_drawing(node))
        read_drawing(node, holder, key, reading);
    else if (key.skeleton == nullptr && std::ranges::none_of(node.properties, is_setting))
        report_idle_key(key, holder, reading);
    const auto time = clock.read_moment(moment, reading);
    if (!time)
        return std::nullopt;
    key.time = *time;
    return key;
}

std::vector<NodeWords> key_words()
{
    return {{key_name,
             drawing_key_form,
             {any_moment},
             words_of(object_key_rules),
             drawn_ids(names_inside(KeyHolder::object))},
            {group_key_id, group_key_form, {any_moment}, words_of(group_key_rules)},
            {symbol_key_id,
             drawing_key_form,
             {any_time},
             words_of(symbol_key_rules),
             drawn_ids(names_inside(KeyHolder::symbol))}};
}

}
