#include "host/compiler/compile.hpp"

#include "host/compiler/drifting_arcs.hpp"
#include "host/compiler/item_origins.hpp"
#include "host/compiler/limits/allowance.hpp"
#include "host/compiler/stroke_order.hpp"
#include "host/compiler/write_scene.hpp"
#include "host/kdl/parser.hpp"
#include "host/scene/scene_reader.hpp"

namespace kfast {

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
