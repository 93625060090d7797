#include "host/scene/items/symbol_use.hpp"

#include "host/scene/context/limits.hpp"
#include "host/scene/items/drawing_reader.hpp"
#include "host/scene/items/item_reader.hpp"
#include "host/scene/items/key_reader.hpp"
#include "host/scene/items/symbol_reader.hpp"
#include "host/scene/items/track_reader.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/schema/node_form.hpp"
#include "host/schema/property_rule.hpp"
#include "host/text/characters.hpp"

#include <algorithm>

namespace kfast::scene {

namespace {

constexpr NodeForm items_form{use_name, "use SYMBOL X Y", 1, 3, true};
constexpr NodeForm drawing_form{use_name, "use SYMBOL X Y", 1, 3};

constexpr std::array mirrors{Word<Mirror>{"x", {true, false}}, Word<Mirror>{"y", {false, true}},
                             Word<Mirror>{"both", {true, true}}};

bool read_mirror(const kdl::Value& value, SymbolUse& use, SceneContext& context)
{
    return assign(read_word(value, mirrors, context.report), use.mirror);
}

constexpr std::array mirror_rules{
    PropertyRule<SymbolUse>{"mirror", read_mirror, ValueKind::one_of<mirrors>()}};
constexpr auto drawing_rules =
    joined(place_rules<SymbolUse>, mirror_rules, own_time_rules<SymbolUse>, repeat_rules<SymbolUse>);
constexpr auto items_rules =
    joined(drawing_rules, item_repeat_rules<SymbolUse>, show_rules<SymbolUse>, pivot_rules<SymbolUse>,
           std::array{PropertyRule<SymbolUse>{"input", read_own_driver<SymbolUse>, any_name}});

/// The position may follow the name of the symbol instead of being in properties.
void read_coordinate(const kdl::Node& node, std::size_t argument, std::string_view name,
                     std::optional<std::int32_t>& target, SceneContext& context)
{
    if (has_property(node, name))
        context.report.error(property_span(node, name), std::string{name} + " is given twice",
                             "leave out " + std::string{name} + "=… or the numbers behind the symbol");
    else
        assign(read_item_value(Property::x, node.arguments[argument], context), target);
}

void read_place(const kdl::Node& node, ItemValues& values, SceneContext& context)
{
    if (node.arguments.size() == 2)
        context.report.error(node.arguments.back().place, "this x has no y", "write use SYMBOL X Y");
    if (node.arguments.size() != 3)
        return;
    read_coordinate(node, 1, "x", values[Property::x], context);
    read_coordinate(node, 2, "y", values[Property::y], context);
}

bool is_of_kind(SymbolEntry::Kind kind, const SymbolUse& use, const kdl::Value& name, SceneContext& context)
{
    const SymbolEntry& symbol = *use.symbol;
    if (symbol.kind == kind)
        return true;
    if (kind == SymbolEntry::Kind::items)
        return context.report.error(name.place, "the symbol " + in_quotes(symbol.name) + " is a drawing",
                                    "put its use into an object, which gives it a colour");
    return context.report.error(name.place,
                                "the symbol " + in_quotes(symbol.name) + " holds items, no drawing",
                                "use it beside objects, not inside one");
}

template <std::size_t count>
std::optional<SymbolUse> read_use(const kdl::Node& node, SymbolEntry::Kind kind, const NodeForm& form,
                                  const std::array<PropertyRule<SymbolUse>, count>& rules,
                                  SceneContext& context)
{
    if (!fits(node, form, context.report))
        return std::nullopt;
    SymbolUse use;
    read_properties(node, rules, use, context);
    read_place(node, use.values, context);
    const kdl::Value& name = node.arguments.front();
    use.symbol = find_symbol(name, context);
    if (use.symbol == nullptr || !is_of_kind(kind, use, name, context) || !has_count_for_steps(node, context))
        return std::nullopt;
    const auto inner = own_driver(use.time, *use.symbol, span(node.name_span, name.place), context);
    if (!inner)
        return std::nullopt;
    use.inner = *inner;
    take_pass(*use.symbol, use.inner, context);
    return use;
}

}

std::optional<SymbolUse> read_items_use(const kdl::Node& node, SceneContext& context)
{
    return read_use(node, SymbolEntry::Kind::items, items_form, items_rules, context);
}

std::optional<SymbolUse> read_drawing_use(const kdl::Node& node, SceneContext& context)
{
    auto use = read_use(node, SymbolEntry::Kind::drawing, drawing_form, drawing_rules, context);
    if (use && !use->symbol->line_font.empty() && !context.line_letters)
        context.line_letters = LineLetters{use->symbol->line_font, node.arguments.front().place};
    return use;
}

std::vector<NodeSchema> use_schema()
{
    const ValueKind coordinate = kind_of(Property::x);
    return {
        {use_name, items_form, {any_name, coordinate}, schema_of(items_rules), {group_key_id, track_name}},
        {drawing_use_id, drawing_form, {any_name, coordinate}, schema_of(drawing_rules)}};
}

namespace {

/// Nothing if all that it holds are uses, or unknown.
std::optional<SymbolEntry::Kind> kind_by_content(const SymbolEntry& symbol)
{
    if (symbol.kind)
        return symbol.kind;
    for (const kdl::Node& node : symbol.node->children) {
        if (node.name == use_name)
            continue;
        if (is_item(node.name))
            return SymbolEntry::Kind::items;
        if (node.name == key_name || is_drawn(node.name))
            return SymbolEntry::Kind::drawing;
    }
    return std::nullopt;
}

SymbolEntry* first_used(const SymbolEntry& symbol, SymbolTable& symbols)
{
    const auto use = std::ranges::find(symbol.node->children, use_name, &kdl::Node::name);
    if (use == symbol.node->children.end() || use->arguments.empty())
        return nullptr;
    const std::string* const name = use->arguments.front().string();
    return name == nullptr ? nullptr : symbols.find(*name);
}

}

SymbolEntry::Kind symbol_kind(const SymbolEntry& symbol, SymbolTable& symbols)
{
    const SymbolEntry* at = &symbol;
    // A longer chain is refused anyway.
    for (int i = 0; i <= deepest_item + 1 && at != nullptr; ++i) {
        if (const auto kind = kind_by_content(*at))
            return *kind;
        at = first_used(*at, symbols);
    }
    return SymbolEntry::Kind::items;
}

void report_mixed_kinds(const kdl::Node& node, SceneContext& context)
{
    context.report.error(node.name_span, "a symbol holds either items or a drawing, not both",
                         "put shapes and keys into an object of the symbol");
}

}
