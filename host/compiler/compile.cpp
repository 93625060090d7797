#include "host/compiler/compile.hpp"

#include "host/compiler/drifting_arcs.hpp"
#include "host/compiler/limits/allowance.hpp"
#include "host/compiler/stroke_order.hpp"
#include "host/compiler/write_scene.hpp"
#include "host/kdl/parser.hpp"
#include "host/scene/model.hpp"
#include "host/scene/scene_reader.hpp"
#include "host/text/source.hpp"

#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace kfast {

namespace {

/// Where the items of a .kfb come from, in the order in which it stores them, as every_item() reads them.
struct ItemOrigins {
    std::vector<std::string> names; ///< for a use without a name that of its symbol
    std::vector<SourceSpan> places; ///< in the text
    StoredNames other_names;        ///< of symbols, skeletons and bones
};

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

ItemOrigins item_origins(const scene::Scene& scene) { return OriginList{scene}.take(); }

}

std::optional<std::vector<std::byte>> compile(const SourceText& source, Diagnostics& diagnostics)
{
    auto compiled = compile_with_names(source, diagnostics);
    if (!compiled)
        return std::nullopt;
    return std::move(compiled->bytes);
}

std::optional<CompiledScene> compile_with_names(const SourceText& source, Diagnostics& diagnostics,
                                                const ProgressCallback& on_progress)
{
    const kdl::Document document = kdl::parse(source.text, diagnostics);
    if (diagnostics.has_errors()) // what was not read would only cause errors that follow from these
        return std::nullopt;
    std::optional<scene::Scene> scene = scene::read_scene(document, source, diagnostics);
    if (!scene)
        return std::nullopt;
    check_matching(*scene, diagnostics);
    if (diagnostics.has_errors())
        return std::nullopt;
    warn_of_drifting_arcs(*scene, diagnostics);
    if (scene->has_routes)
        order_strokes(*scene);
    auto bytes = write_scene(*scene, diagnostics, on_progress);
    if (!bytes)
        return std::nullopt;
    ItemOrigins origins = item_origins(*scene);
    return CompiledScene{std::move(*bytes), std::move(origins.names), std::move(origins.places),
                         std::move(origins.other_names)};
}

}
