#include "core/scene/scene_view.hpp"
#include "host/compiler/compile.hpp"
#include "host/text/diagnostic.hpp"
#include "host/text/source.hpp"
#include "tests/demand.hpp"
#include "tests/fuzz/played.hpp"

#include <cstdint>
#include <string>

/// Any text: there is an error with its place, or a scene that plays.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace kfast;
    const SourceText source{.name = "fuzz", .text = std::string(data, data + size)};
    Diagnostics diagnostics;
    const auto file = compile(source, diagnostics);
    demand(file.has_value() != diagnostics.has_errors());
    if (!file)
        return 0;
    demand(static_cast<bool>(SceneView::parse(*file)));
    test::play(*file);
    return 0;
}
