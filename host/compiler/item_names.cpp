#include "host/compiler/item_names.hpp"

#include <utility>
#include <variant>

namespace kfast {
namespace {

class ItemNames {
public:
    explicit ItemNames(const scene::Scene& scene) : scene_{scene}
    {
        for (const scene::Symbol& symbol : scene.symbols)
            add(symbol.items);
        add(scene.items);
    }

    std::vector<std::string> take() { return std::move(names_); }

private:
    void add(const std::vector<scene::Item>& items)
    {
        for (const scene::Item& item : items) {
            names_.push_back(name_of(item));
            if (const auto* group = std::get_if<scene::Group>(&item.content))
                add(group->items);
        }
    }

    const std::string& name_of(const scene::Item& item) const
    {
        const auto* const use = std::get_if<scene::Use>(&item.content);
        return use != nullptr && item.name.empty() ? scene_.symbols[use->symbol].name : item.name;
    }

    const scene::Scene& scene_;
    std::vector<std::string> names_;
};

}

std::vector<std::string> item_names(const scene::Scene& scene) { return ItemNames{scene}.take(); }

}
