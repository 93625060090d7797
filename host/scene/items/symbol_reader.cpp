#include "host/scene/items/symbol_reader.hpp"

#include "host/scene/context/limits.hpp"
#include "host/scene/context/tables.hpp"
#include "host/scene/items/drawing_content.hpp"
#include "host/scene/items/drawing_reader.hpp"
#include "host/scene/items/item_reader.hpp"
#include "host/scene/items/symbol_use.hpp"
#include "host/scene/items/track_builder.hpp"
#include "host/scene/model.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/schema/node_form.hpp"
#include "host/schema/property_rule.hpp"
#include "host/text/characters.hpp"
#include "host/text/suggestion.hpp"
#include "host/words/synonyms.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <utility>
#include <variant>

namespace kfast::scene {

namespace {

/// How deeply groups and uses are nested in `items`, in which a Use has the number of an entry in `symbols`,
/// which has been read.
int depth_of(std::span<const Item> items, const SymbolTable& symbols);

int depth_of(const Item& item, const SymbolTable& symbols)
{
    if (const Group* const group = std::get_if<Group>(&item.content))
        return depth_of(group->items, symbols) + 1;
    if (const Use* const use = std::get_if<Use>(&item.content))
        return symbols.entries[use->symbol].depth + 1;
    return 0;
}

int depth_of(std::span<const Item> items, const SymbolTable& symbols)
{
    int depth = 0;
    for (const Item& item : items)
        depth = std::max(depth, depth_of(item, symbols));
    return depth;
}

constexpr NodeForm symbol_form{symbol_name, "symbol NAME { items, shapes or keys }", 1, 1, true};

constexpr std::array symbol_rules{
    PropertyRule<SymbolEntry>{"frames",
                              [](const kdl::Value& value, SymbolEntry& symbol, SceneContext& context) {
                                  return assign(read_own_length(value, context), symbol.length);
                              },
                              any_time},
    PropertyRule<SymbolEntry>{"loop",
                              [](const kdl::Value& value, SymbolEntry& symbol, SceneContext& context) {
                                  return assign(read_loop(value, context), symbol.loop);
                              },
                              ValueKind::one_of<loops>()},
};

void report_no_item(const kdl::Node& node, SceneContext& context)
{
    if (node.name == key_name || is_drawn(node.name))
        report_mixed_kinds(node, context);
    else
        context.report.error(node.name_span, "a symbol has no node " + in_quotes(node.name),
                             word_hint(node.name, item_names()));
}

void read_items(SymbolEntry& symbol, SceneContext& context)
{
    for (const kdl::Node& node : symbol.node->children) {
        if (context.report.full())
            break;
        if (is_item(node.name))
            read_item(node, 0, symbol.items, context);
        else
            report_no_item(node, context);
    }
    refuse_crowded_order(symbol.items, context);
    symbol.depth = depth_of(symbol.items, context.symbols);
}

void read_still(const std::vector<const kdl::Node*>& nodes, SymbolEntry& symbol, SceneContext& context)
{
    DrawingReader drawing{context};
    drawing.read(nodes);
    symbol.depth = drawing.depth();
    symbol.still = drawing.take_outlines();
    symbol.keys = {Key{.time = {},
                       .laws = {},
                       .match = Match::count,
                       .drawing = drawing.take(),
                       .depths = drawing.take_depths(),
                       .place = symbol.place}};
}

void read_drawing(SymbolEntry& symbol, SceneContext& context)
{
    const auto outer_letters = std::exchange(context.line_letters, std::nullopt); // of what uses it first
    DrawingContent content = read_drawing_content(*symbol.node, KeyHolder::symbol, {}, context);
    if (content.drawn.empty())
        symbol.keys = take_drawings(content.keys);
    else
        read_still(content.drawn, symbol, context);
    if (const auto letters = std::exchange(context.line_letters, outer_letters))
        symbol.line_font = letters->font;
}

/// What is seen of its keys ends with its own length, if it has one; how long the scene has to be for them,
/// its uses say.
void read_content(SymbolEntry& symbol, SceneContext& context)
{
    const Time outer_key = std::exchange(context.last_key, Time{});
    const auto outer_length = std::exchange(context.length, symbol.length ? symbol.length : context.length);
    if (symbol.kind == SymbolEntry::Kind::items)
        read_items(symbol, context);
    else
        read_drawing(symbol, context);
    context.length = outer_length;
    symbol.last_key = std::exchange(context.last_key, outer_key);
}

void read_symbol(SymbolEntry& symbol, SceneContext& context)
{
    symbol.state = SymbolEntry::State::in_progress;
    context.symbols.in_progress.push_back(&symbol);
    symbol.kind = symbol_kind(symbol, context.symbols);
    read_content(symbol, context);
    context.symbols.in_progress.pop_back();
    symbol.state = SymbolEntry::State::good;
    if (!symbol.node->children.empty())
        return;
    symbol.state = SymbolEntry::State::bad;
    context.report.error(symbol.place, "this symbol holds nothing", "add objects, or shapes");
}

/// "a → b → a"
std::string chain(const SymbolEntry& symbol, const SymbolTable& symbols)
{
    const auto begin = std::ranges::find(symbols.in_progress, &symbol);
    std::string names;
    for (auto user = begin; user != symbols.in_progress.end(); ++user)
        names += visible((*user)->name) + " → ";
    return names + visible(symbol.name);
}

/// Reported once: the rest of a long chain will be read from somewhere else, and be too long as well.
bool report_chain(SourceSpan use, SceneContext& context)
{
    if (!std::exchange(context.symbols.has_long_chain, true))
        context.report.error(use, too_deep());
    return false;
}

/// Whether it may be used, as far as that is known without its kind.
bool make_ready(SymbolEntry& symbol, SourceSpan use, SceneContext& context)
{
    if (symbol.state == SymbolEntry::State::in_progress)
        return context.report.error(use, "the symbol " + in_quotes(symbol.name) + " uses itself",
                                    chain(symbol, context.symbols));
    if (symbol.state == SymbolEntry::State::unread) {
        if (context.symbols.in_progress.size() > std::size_t{deepest_item})
            return report_chain(use, context);
        read_symbol(symbol, context);
    }
    return symbol.state == SymbolEntry::State::good;
}

}

void add_symbol(const kdl::Node& node, SceneContext& context)
{
    if (!fits(node, symbol_form, context.report))
        return;
    const kdl::Value& value = node.arguments.front();
    const auto name = read_name(value, context.report);
    if (!name)
        return;
    SymbolEntry entry;
    entry.node = &node;
    entry.name = *name;
    entry.place = span(node.name_span, value.place);
    read_properties(node, symbol_rules, entry, context);
    if (const auto earlier = context.symbols.add(entry))
        report_duplicate("a symbol", *name, entry.place, *earlier, context.report);
}

const SymbolEntry* find_symbol(const kdl::Value& name, SceneContext& context)
{
    const auto text = read_name(name, context.report);
    if (!text)
        return nullptr;
    SymbolEntry* const symbol = context.symbols.find(*text);
    if (symbol == nullptr) {
        const auto known = context.symbols.names();
        context.report.error(name.place, "unknown symbol " + in_quotes(*text),
                             known.empty() ? "write it on the outermost level: symbol NAME { … }"
                                           : suggestion(*text, known));
        return nullptr;
    }
    symbol->is_used = true;
    return make_ready(*symbol, name.place, context) ? symbol : nullptr;
}

void check_unused_symbols(SceneContext& context)
{
    for (SymbolEntry& symbol : context.symbols.entries)
        if (symbol.state == SymbolEntry::State::unread && !context.report.full())
            read_symbol(symbol, context);
    for (const SymbolEntry& symbol : context.symbols.entries)
        if (!symbol.is_used && !context.report.full())
            context.report.warning(symbol.place, "the symbol " + in_quotes(symbol.name) + " is not used",
                                   "use it, or remove it");
}

namespace {

/// What is in a symbol with a time of its own goes by it, too.
void spread_own_times(SymbolTable& symbols)
{
    const auto is_retimed = [&symbols](std::size_t user) { return symbols.entries[user].is_retimed; };
    for (bool has_spread = true; has_spread;) {
        has_spread = false;
        for (SymbolEntry& symbol : symbols.entries)
            if (!symbol.is_retimed && std::ranges::any_of(symbol.users, is_retimed))
                symbol.is_retimed = has_spread = true;
    }
}

}

void warn_of_late_keys(SceneContext& context)
{
    spread_own_times(context.symbols);
    for (const SymbolEntry& symbol : context.symbols.entries)
        if (!symbol.late_keys.empty() && !symbol.is_retimed)
            for (const auto& [noun, place] : symbol.late_keys)
                context.report.warning(place, "the scene ends before anything of this " + noun + " is seen",
                                       "make the scene longer with frames=… or remove the " + noun);
}

std::vector<NodeSchema> symbol_schema()
{
    std::vector<std::string_view> drawn{symbol_key_id};
    std::ranges::copy(drawn_ids(drawn_names()), std::back_inserter(drawn));
    return {{symbol_name,
             symbol_form,
             {any_name},
             schema_of(symbol_rules),
             {item_names().begin(), item_names().end()}},
            {symbol_name, symbol_form, {any_name}, schema_of(symbol_rules), drawn}};
}

}
