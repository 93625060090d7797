#include "host/import/import_scene.hpp"

#include "host/archive/gzip.hpp"
#include "host/archive/zip_file.hpp"
#include "host/art/prepare.hpp"
#include "host/failure.hpp"
#include "host/import/canvas_size.hpp"
#include "host/import/content_kind.hpp"
#include "host/import/dot_lottie.hpp"
#include "host/input_file.hpp"
#include "host/lottie/read_lottie.hpp"
#include "host/scene_text/scene_text.hpp"
#include "host/svg/read_keys.hpp"
#include "host/svg/read_svg.hpp"
#include "host/synfig/read_synfig.hpp"
#include "host/text/excerpt.hpp"
#include "host/text/glyph.hpp"

#include <algorithm>
#include <utility>

namespace kfast::importing {
namespace {

constexpr const char* known_files =
    "kfast imports Lottie (.json, .lottie), SVG (.svg, .svgz) and Synfig (.sif, .sifz)";

[[noreturn]] void refuse(const std::string& name, const std::string& reason)
{
    throw Failure(name + ": " + reason);
}

std::string unpacked(const std::string& name, std::string content)
{
    return archive::is_gzip(content) ? archive::gunzipped(name, content, most_unpacked_bytes)
                                     : std::move(content);
}

using Notes = std::vector<std::string>;

art::Document read_xml(const SourceText& source, const Options& options, art::Losses& losses, Notes& notes)
{
    const std::string_view root = root_element(source.text);
    if (root == "svg")
        return svg::read_svg(source, options.drawings, losses, notes);
    if (root == "canvas")
        return synfig::read_synfig(source, losses);
    refuse(source.name, "an XML file, but neither SVG nor Synfig: " + std::string{known_files});
}

void apply(const Playing& playing, art::Document& document)
{
    document.frame_rate *= playing.speed;
    if (playing.loop)
        document.loop = *playing.loop;
    if (playing.background)
        document.background = playing.background;
}

art::Document read_zip(const SourceText& source, const Options& options, art::Losses& losses)
{
    const archive::ZipFile file{source.name, source.text};
    PackedAnimation animation =
        read_dot_lottie(source.name, file, options.animation, most_unpacked_bytes, losses);
    art::Document document = lottie::read_lottie({source.name, std::move(animation.text)}, losses);
    apply(animation.playing, document);
    return document;
}

art::Document read(const SourceText& source, const Options& options, art::Losses& losses, Notes& notes)
{
    const auto kind = kind_of(source.text);
    if (kind != ContentKind::zip && !options.animation.empty())
        refuse(source.name, "--animation chooses among those of a .lottie file, and this is none");
    if (!kind)
        refuse(source.name, std::string{"nothing that can be imported: "} + known_files);
    switch (*kind) {
    case ContentKind::json:
        return lottie::read_lottie(source, losses);
    case ContentKind::xml:
        return read_xml(source, options, losses, notes);
    case ContentKind::zip:
        return read_zip(source, options, losses);
    case ContentKind::gzip:
        refuse(source.name, "is packed twice: unpack it once");
    case ContentKind::utf_16:
        break;
    }
    refuse(source.name, "the text is in UTF-16: save it as UTF-8");
}

/// The text cannot be seen: what is wrong with it is either a limit that is exceeded, or a mistake of kfast.
CompiledScene compiled(const std::string& name, const std::string& text)
{
    Diagnostics diagnostics;
    const SourceText source{.name = name, .text = text};
    auto scene = compile_with_names(source, diagnostics);
    const std::vector<Diagnostic> found = diagnostics.sorted();
    if (scene && found.empty())
        return std::move(*scene);
    const auto first = std::ranges::find(
        found, diagnostics.has_errors() ? Severity::error : Severity::warning, &Diagnostic::severity);
    refuse(
        name,
        "no scene can be made of it: " + first->message + " (" + visible(excerpt(text, first->place).line) +
            "). If that names no limit of scenes, it is a mistake in kfast: please report it, with the file");
}

Imported made_of(art::Document document, const std::string& name, const Options& options, art::Losses losses)
{
    Imported imported;
    fit_canvas(document, options.size, losses);
    art::crop(document, losses);
    art::simplify(document, options.tolerance);
    imported.text = scene_text::scene_text(document, name, options.tolerance, losses);
    if (imported.text.size() > most_scene_text_bytes)
        refuse(name,
               "makes a scene text larger than 4 MB, more than kfast reads: draw less, or raise --tolerance");
    imported.compiled = compiled(name, imported.text);
    imported.extent = extent_of(document);
    imported.losses = std::move(losses);
    return imported;
}

}

bool can_import(std::string_view content) { return kind_of(content).has_value(); }

Imported import_scene(const std::string& name, std::string content, const Options& options)
{
    art::Losses losses;
    Notes notes;
    art::Document document = read({name, unpacked(name, std::move(content))}, options, losses, notes);
    Imported imported = made_of(std::move(document), name, options, std::move(losses));
    imported.notes = std::move(notes);
    return imported;
}

Imported import_key_drawings(std::vector<SourceText> drawings, std::span<const double> times,
                             const Options& options)
{
    for (SourceText& drawing : drawings) {
        drawing.text = unpacked(drawing.name, std::move(drawing.text));
        if (kind_of(drawing.text) != ContentKind::xml || root_element(drawing.text) != "svg")
            refuse(drawing.name, "is no SVG file, as key drawings are");
    }
    art::Losses losses;
    art::Document document = svg::read_svg_keys(drawings, times, options.drawings, losses);
    const std::string name = drawings.empty() ? "" : drawings.front().name;
    return made_of(std::move(document), name, options, std::move(losses));
}

}
