#include "host/import/import_scene.hpp"

#include "host/lottie/read_lottie.hpp"
#include "host/scene_text/scene_text.hpp"
#include "host/svg/read_svg.hpp"
#include "host/synfig/read_synfig.hpp"
#include "host/text/source.hpp"

#include <utility>

namespace kfast::importing {
namespace {

art::Document read(const SourceText& source, art::Losses& losses)
{
    if (source.text.find('{') == 0)
        return lottie::read_lottie(source, losses);
    if (source.text.find("<svg") < 4096)
        return svg::read_svg(source, losses);
    return synfig::read_synfig(source, losses);
}

}

bool can_import(std::string_view content) { return content.starts_with('{') || content.starts_with('<'); }

Imported import_scene(const std::string& name, std::string content, const Options& options)
{
    Imported imported;
    art::Document document = read({name, std::move(content)}, imported.losses);
    art::crop(document, imported.losses);
    art::simplify(document, options.tolerance);
    imported.text = scene_text::scene_text(document, name, options.tolerance, imported.losses);
    return imported;
}

}
