#include "host/scene_text/items/symbol_text.hpp"

#include "host/scene_text/items/item_text.hpp"
#include "host/scene_text/values/nodes.hpp"

#include <utility>

namespace kfast::scene_text {
namespace {

/// Calls visit(symbol) for each use in nodes.
template <typename Visit>
void every_use(const std::vector<art::Node>& nodes, const Visit& visit)
{
    for (const art::Node& node : nodes)
        if (const auto* const group = std::get_if<art::Group>(&node.content))
            every_use(group->nodes, visit);
        else if (const auto* const use = std::get_if<art::Use>(&node.content))
            visit(use->symbol);
}

std::vector<bool> used_symbols(const art::Document& document)
{
    std::vector<bool> used(document.symbols.size());
    const auto take = [&used](std::size_t symbol) { used[symbol] = true; };
    every_use(document.nodes, take);
    // Each comes after those that it uses.
    for (std::size_t i = used.size(); i-- > 0;)
        if (used[i])
            every_use(document.symbols[i].nodes, take);
    return used;
}

kdl::Node symbol_node(const art::Symbol& symbol, const std::string& name, Writing& writing)
{
    kdl::Node node = named_node("symbol", text(name));
    if (symbol.loop) {
        set(node, "frames", number(writing.length, times));
        if (*symbol.loop != Loop::repeat)
            set(node, "loop", loop_word(*symbol.loop));
    }
    node.children = item_nodes(symbol.nodes, writing);
    return node;
}

}

void end_symbols(art::Document& document)
{
    for (std::size_t i = document.symbols.size(); i-- > 0;) {
        art::Symbol& symbol = document.symbols[i];
        if (!symbol.loop && symbol.frames > document.frames)
            symbol.loop = Loop::once;
        if (symbol.loop)
            every_use(symbol.nodes, [&](std::size_t inner) {
                if (!document.symbols[inner].loop)
                    document.symbols[inner].loop = Loop::once;
            });
    }
}

void name_symbols(const art::Document& document, Writing& writing)
{
    const std::vector<bool> used = used_symbols(document);
    for (std::size_t i = 0; i < document.symbols.size(); ++i)
        writing.symbols.push_back(used[i] ? writing.symbol_names.unique(document.symbols[i].name, "symbol")
                                          : std::string{});
}

std::vector<kdl::Node> symbol_nodes(const art::Document& document, Writing& writing)
{
    const std::int32_t length = writing.length;
    std::vector<kdl::Node> nodes;
    for (std::size_t i = 0; i < document.symbols.size(); ++i) {
        if (writing.symbols[i].empty())
            continue;
        writing.length = length_of(document.symbols[i]);
        nodes.push_back(symbol_node(document.symbols[i], writing.symbols[i], writing));
    }
    writing.length = length;
    return nodes;
}

}
