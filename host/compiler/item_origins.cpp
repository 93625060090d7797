#include "host/compiler/item_origins.hpp"

#include <utility>
#include <variant>

namespace kfast {
namespace {

class OriginList {
public:
    explicit OriginList(const scene::Scene& scene) : scene_{scene}
    {
        for (const scene::Symbol& symbol : scene.symbols) {
            origins_.other_names.symbols.push_back(symbol.name);
            add(symbol.items);
        }
        add(scene.items);
        for (const scene::Bones& bones : scene.bones)
            add(bones);
    }

    ItemOrigins take() { return std::move(origins_); }

private:
    void add(const std::vector<scene::Item>& items)
    {
        for (const scene::Item& item : items) {
            origins_.names.push_back(name_of(item));
            origins_.places.push_back(item.place);
            if (const auto* group = std::get_if<scene::Group>(&item.content))
                add(group->items);
        }
    }

    void add(const scene::Bones& skeleton)
    {
        SkeletonNames& names = origins_.other_names.skeletons.emplace_back();
        names.name = skeleton.name;
        for (const scene::Bone& bone : skeleton.bones)
            names.bones.push_back(bone.name);
    }

    const std::string& name_of(const scene::Item& item) const
    {
        const auto* const use = std::get_if<scene::Use>(&item.content);
        return use != nullptr && item.name.empty() ? scene_.symbols[use->symbol].name : item.name;
    }

    const scene::Scene& scene_;
    ItemOrigins origins_;
};

}

ItemOrigins item_origins(const scene::Scene& scene) { return OriginList{scene}.take(); }

}
