#include "host/import/import_scene.hpp"
#include "host/program/failure.hpp"

// In place of import_scene.cpp where KFAST_IMPORTERS is off.

namespace kfast::importing {
namespace {

[[noreturn]] void refuse(const std::string& name)
{
    throw Failure(name + ": this kfast was built without what reads Lottie, SVG and Synfig: scripts/build "
                         "command adds it");
}

}

Imported import_scene(const std::string& name, std::string /*content*/, const Options& /*options*/)
{
    refuse(name);
}

Imported import_key_drawings(std::vector<SourceText> drawings, std::span<const double> /*times*/,
                             const Options& /*options*/)
{
    refuse(drawings.empty() ? "import" : drawings.front().name);
}

}
