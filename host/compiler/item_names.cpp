#include "host/compiler/item_names.hpp"

#include <variant>

namespace kfast {
namespace {

void add(const std::vector<scene::Item>& items, std::vector<std::string>& names)
{
    for (const scene::Item& item : items) {
        names.push_back(item.name);
        if (const auto* group = std::get_if<scene::Group>(&item.content))
            add(group->items, names);
    }
}

}

std::vector<std::string> item_names(const scene::Scene& scene)
{
    std::vector<std::string> names;
    for (const scene::Symbol& symbol : scene.symbols)
        add(symbol.items, names);
    add(scene.items, names);
    return names;
}

}
