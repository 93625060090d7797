#include "host/scene/items/symbol_kind.hpp"

#include "host/scene/context/limits.hpp"
#include "host/scene/items/drawing_reader.hpp"
#include "host/scene/items/item_reader.hpp"
#include "host/scene/items/key_reader.hpp"
#include "host/scene/items/symbol_use.hpp"

#include <algorithm>

namespace kfast::scene {
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
