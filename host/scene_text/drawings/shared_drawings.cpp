#include "host/scene_text/drawings/shared_drawings.hpp"

#include "host/kdl/readable.hpp"
#include "host/scene_text/values/names.hpp"
#include "host/scene_text/values/nodes.hpp"

#include <map>
#include <string>
#include <utility>

namespace kfast::scene_text {
namespace {

/// What is shorter is written again.
constexpr std::size_t shortest = 60;

/// A drawing that stands in keys.
struct Shared {
    std::string user; ///< the first object that has it
    std::vector<kdl::Node*> keys;
};

class Drawings {
public:
    void collect(std::vector<kdl::Node>& items)
    {
        for (kdl::Node& item : items)
            if (item.name == "object")
                collect_keys(item);
            else
                collect(item.children);
    }

    std::vector<kdl::Node> share()
    {
        std::vector<kdl::Node> symbols;
        Names names;
        for (const std::string* text : order_) {
            const Shared& shared = drawings_.at(*text);
            if (shared.keys.size() < 2)
                continue;
            const std::string name = names.unique(shared.user + "-drawing", "drawing");
            kdl::Node symbol = named_node("symbol", scene_text::text(name));
            symbol.children = std::move(shared.keys.front()->children);
            symbols.push_back(std::move(symbol));
            for (kdl::Node* key : shared.keys)
                key->children = {named_node("use", scene_text::text(name))};
        }
        return symbols;
    }

private:
    void collect_keys(kdl::Node& object)
    {
        for (kdl::Node& key : object.children) {
            if (key.name != "key" || key.children.empty())
                continue;
            const std::string drawing = kdl::readable(key.children, {});
            if (drawing.size() < shortest)
                continue;
            const auto [entry, is_new] = drawings_.try_emplace(drawing);
            if (is_new) {
                entry->second.user = *object.arguments.front().string();
                order_.push_back(&entry->first);
            }
            entry->second.keys.push_back(&key);
        }
    }

    std::map<std::string, Shared> drawings_ = {};
    std::vector<const std::string*> order_ = {}; ///< as they stand in the text
};

}

std::vector<kdl::Node> share_drawings(std::vector<kdl::Node>& items)
{
    Drawings drawings;
    drawings.collect(items);
    return drawings.share();
}

}
