#include "host/compiler/compile.hpp"

#include "host/compiler/write_scene.hpp"
#include "host/kdl/parser.hpp"
#include "host/scene/scene_reader.hpp"

namespace kfast {

std::optional<std::vector<std::byte>> compile(const SourceText& source, Diagnostics& diagnostics)
{
    const kdl::Document document = kdl::parse(source.text, diagnostics);
    if (diagnostics.has_errors()) // what was not read would only cause errors that follow from these
        return std::nullopt;
    const std::optional<scene::Scene> scene = scene::read_scene(document, source, diagnostics);
    if (!scene)
        return std::nullopt;
    return write_scene(*scene, diagnostics);
}

}
