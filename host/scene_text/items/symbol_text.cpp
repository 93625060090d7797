#include "host/scene_text/items/symbol_text.hpp"

#include "host/scene_text/items/item_text.hpp"
#include "host/scene_text/values/nodes.hpp"
#include "host/words/scene_words.hpp"

#include <utility>

namespace kfast::scene_text {
namespace {

class UsedSymbols {
public:
    explicit UsedSymbols(const art::Document& document) : used_(document.symbols.size())
    {
        look_at(document.nodes);
        // Each comes after those that it uses.
        for (std::size_t i = used_.size(); i-- > 0;)
            if (used_[i])
                look_at(document.symbols[i].nodes);
    }

    bool contain(std::size_t index) const { return used_[index]; }

private:
    void look_at(const std::vector<art::Node>& nodes)
    {
        for (const art::Node& node : nodes)
            if (const auto* const group = std::get_if<art::Group>(&node.content))
                look_at(group->nodes);
            else if (const auto* const use = std::get_if<art::Use>(&node.content))
                used_[use->symbol] = true;
    }

    std::vector<bool> used_;
};

kdl::Node symbol_node(const art::Symbol& symbol, const std::string& name, Writing& writing)
{
    kdl::Node node = named_node("symbol", text(name));
    if (symbol.loop) {
        set(node, "frames", number(writing.length, times));
        if (*symbol.loop != Loop::repeat)
            set(node, "loop", text(std::string{loop_name(*symbol.loop)}));
    }
    node.children = item_nodes(symbol.nodes, writing);
    return node;
}

}

void name_symbols(const art::Document& document, Writing& writing)
{
    const UsedSymbols used{document};
    for (std::size_t i = 0; i < document.symbols.size(); ++i)
        writing.symbols.push_back(used.contain(i)
                                      ? writing.symbol_names.unique(document.symbols[i].name, "symbol")
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
