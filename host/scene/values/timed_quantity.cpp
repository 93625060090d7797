#include "host/scene/values/timed_quantity.hpp"

#include "host/scene/context/limits.hpp"
#include "host/scene/values/item_values.hpp"
#include "host/scene/values/key_driver.hpp"
#include "host/scene/values/law_reader.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/schema/node_form.hpp"
#include "host/schema/property_rule.hpp"
#include "host/text/characters.hpp"
#include "host/words/synonyms.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace kfast::scene {

namespace {

constexpr NodeForm at_form{at_name, "at TIME VALUE", 2, 2};

bool read_law_of_way(const kdl::Value& value, TimedValue& timed, SceneContext& context)
{
    return assign(read_law(value, context.report), timed.law);
}

constexpr std::array at_rules{PropertyRule<TimedValue>{"law", read_law_of_way, any_law}};

std::optional<TimedValue> read_at(const kdl::Node& node, Property property, const KeyDriver& driver,
                                  SceneContext& context)
{
    if (node.name != at_name) {
        context.report.error(node.name_span, "a track has no node " + in_quotes(node.name),
                             word_hint(node.name, std::array{at_name}));
        return std::nullopt;
    }
    if (!fits(node, at_form, context.report))
        return std::nullopt;
    TimedValue timed;
    timed.node = &node;
    timed.place = span(node.name_span, node.arguments.back().place);
    read_properties(node, at_rules, timed, context);
    const auto time = driver.read_moment(node.arguments.front(), context);
    const auto value = read_item_value(property, node.arguments.back(), context);
    const bool is_valid = assign(time, timed.time) && assign(value, timed.value);
    return is_valid ? std::optional{timed} : std::nullopt;
}

/// Keeps the first of those that have the same time. `values` are in the order of their times, and those of
/// one time as they are written.
void refuse_duplicate_times(std::vector<TimedValue>& values, const KeyDriver& driver, SceneContext& context)
{
    const auto is_again = [&](const TimedValue& first, const TimedValue& second) {
        return !comes_later("value", {first.time, first.place}, {second.time, second.place}, driver, context);
    };
    values.erase(std::unique(values.begin(), values.end(), is_again), values.end());
}

}

std::vector<TimedValue> read_timed_values(const kdl::Node& track, Property property, const KeyDriver& driver,
                                          SceneContext& context)
{
    std::vector<TimedValue> values;
    for (const kdl::Node& node : track.children) {
        if (context.report.full())
            break;
        if (values.size() == max_keys) {
            context.report.error(node.name_span, "at most " + std::to_string(max_keys) + " times stand here");
            break;
        }
        if (auto timed = read_at(node, property, driver, context))
            values.push_back(*timed);
    }
    std::ranges::stable_sort(values, {}, &TimedValue::time);
    refuse_duplicate_times(values, driver, context);
    return values;
}

NodeSchema at_schema()
{
    return {at_name, at_form, {any_moment, ValueKind::number({})}, schema_of(at_rules)};
}

}
