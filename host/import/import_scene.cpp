#include "host/import/import_scene.hpp"

#include "host/archive/archive.hpp"
#include "host/art/prepare/prepare.hpp"
#include "host/file/input_file.hpp"
#include "host/import/content_kind.hpp"
#include "host/import/dot_lottie.hpp"
#include "host/import/extent.hpp"
#include "host/lottie/read_lottie.hpp"
#include "host/program/failure.hpp"
#include "host/scene_text/scene_text.hpp"
#include "host/svg/read_svg.hpp"
#include "host/synfig/read_synfig.hpp"
#include "host/text/characters.hpp"
#include "host/text/source.hpp"

#include <algorithm>
#include <utility>

namespace kfast::importing {
namespace {

constexpr const char* known_files =
    "kfast imports Lottie (.json, .lottie), SVG (.svg, .svgz) and Synfig (.sif, .sifz)";

/// A text was made that does not compile, whatever the file holds.
class Mistake : public Failure {
public:
    using Failure::Failure;
};

[[noreturn]] void refuse(const std::string& name, const std::string& reason)
{
    throw Failure(name + ": " + reason);
}

/// What SVG is drawn on; shapes without a colour are black.
constexpr Colour paper{255, 255, 255};

std::string unpacked(const std::string& name, std::string content)
{
    return archive::is_gzip(content) ? archive::gunzipped(name, content, max_unpacked_bytes)
                                     : std::move(content);
}

/// Sets the background of a document that does not specify one.
void put_behind(art::Document& document, Colour colour)
{
    if (!document.background)
        document.background = {colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0};
}

art::Document on_paper(art::Document document, const Options& options)
{
    put_behind(document, options.background.value_or(paper));
    return document;
}

using Notes = std::vector<std::string>;

art::Document read_xml(const SourceText& source, const Options& options, art::Losses& losses, Notes& notes)
{
    const std::string_view root = root_element(source.text);
    if (root == "svg")
        return on_paper(svg::read_svg(source, options.drawings, losses, notes), options);
    if (root == "canvas")
        return synfig::read_synfig(source, losses);
    refuse(source.name, "an XML file, but neither SVG nor Synfig: " + std::string{known_files});
}

void apply(const Playing& playing, art::Document& document)
{
    document.frame_rate *= playing.speed;
    if (playing.loop)
        document.loop = *playing.loop;
    if (!document.background) // else a layer covers it
        document.background = playing.background;
}

art::Document read_zip(const SourceText& source, const Options& options, lottie::Repeated repeated,
                       art::Losses& losses)
{
    const archive::ZipFile file{source.name, source.text};
    PackedAnimation animation =
        read_dot_lottie(source.name, file, options.animation, max_unpacked_bytes, losses);
    art::Document document = lottie::read_lottie({source.name, std::move(animation.text)}, losses, repeated);
    apply(animation.playing, document);
    return document;
}

art::Document read(const SourceText& source, const Options& options, lottie::Repeated repeated,
                   art::Losses& losses, Notes& notes)
{
    const auto kind = kind_of(source.text);
    if (kind != ContentKind::zip && !options.animation.empty())
        refuse(source.name, "--animation chooses among those of a .lottie file, and this is none");
    if (!kind)
        refuse(source.name, std::string{"nothing that can be imported: "} + known_files);
    if (root_element(source.text) != "svg" && options.drawings != svg::KeyOptions{})
        refuse(source.name, "--fps, --law, --end and --layers are for key drawings of SVG, and this is none");
    switch (*kind) {
    case ContentKind::json:
        return lottie::read_lottie(source, losses, repeated);
    case ContentKind::xml:
        return read_xml(source, options, losses, notes);
    case ContentKind::zip:
        return read_zip(source, options, repeated, losses);
    case ContentKind::gzip:
        refuse(source.name, "is packed twice: unpack it once");
    case ContentKind::utf_16:
        break;
    }
    refuse(source.name, "the text is in UTF-16: save it as UTF-8");
}

/// As the compiler's messages about limits put it; see docs/scene-language.md, "Limits".
bool names_limit(std::string_view message)
{
    const auto has = [message](std::string_view words) {
        return message.find(words) != std::string_view::npos;
    };
    return has("holds") || has("at most") || has("longer than a second") || has("than a player reads") ||
           has("the compiler takes") || has("px away, or more than");
}

/// Reports on a text that the user does not see: either a limit of scenes is exceeded, or kfast is wrong.
[[noreturn]] void refuse_text(const std::string& name, const std::string& text, const Diagnostic& found)
{
    std::string line = visible(excerpt(text, found.place).line);
    line.erase(0, line.find_first_not_of(' '));
    const std::string message = found.message + " (" + line + ')';
    if (names_limit(found.message))
        refuse(name, "more than a scene can be: " + message + (found.hint.empty() ? "" : "; ") + found.hint);
    throw Mistake(name + ": no scene can be made of it: " + message +
                  "; this is a mistake in kfast: please report it, with the file");
}

/// The overall progress when it is read, and when its text is written: compiling takes longest.
constexpr std::size_t steps = 1000;
constexpr std::size_t steps_to_read = 150;
constexpr std::size_t steps_to_write = 300;

ProgressCallback compile_progress(const ProgressCallback& on_progress)
{
    return [on_progress](std::size_t done, std::size_t total) {
        on_progress(steps_to_write + (steps - steps_to_write) * done / total, steps);
    };
}

CompiledScene compiled(const std::string& name, const std::string& text, const ProgressCallback& on_progress)
{
    Diagnostics diagnostics;
    const SourceText source{.name = name, .text = text};
    auto scene = compile_with_names(source, diagnostics, compile_progress(on_progress));
    const std::vector<Diagnostic> found = diagnostics.sorted();
    if (scene && found.empty())
        return std::move(*scene);
    refuse_text(name, text,
                *std::ranges::find(found, diagnostics.has_errors() ? Severity::error : Severity::warning,
                                   &Diagnostic::severity));
}

/// The result if the art is scaled by `share` for the sake of its coordinates.
struct Draft {
    art::Document document;
    art::Losses losses;
    scene_text::SceneText written;
};

Draft drafted(art::Document document, art::Losses losses, double share, const std::string& name,
              const Options& options)
{
    fit_canvas(document, options.size, share, losses);
    art::crop(document, losses);
    art::simplify(document, options.tolerance);
    art::share_eases(document, losses);
    scene_text::SceneText written = scene_text::scene_text(document, name, options.tolerance, losses);
    return {std::move(document), std::move(losses), std::move(written)};
}

bool is_too_large(const art::Document& document)
{
    return std::max(document.width, document.height) > longest_side;
}

Draft draft_of(const art::Document& document, const art::Losses& losses, const std::string& name,
               const Options& options)
{
    Draft draft = drafted(document, losses, 1, name, options);
    if (options.size)
        return draft;
    const double share = share_within_reach(draft.document, draft.written.reach, is_too_large(document));
    return share < 1 ? drafted(document, losses, share, name, options) : std::move(draft);
}

/// What fails while art is simplified and written does not know the file.
Draft named_draft_of(const art::Document& document, const art::Losses& losses, const std::string& name,
                     const Options& options)
{
    try {
        return draft_of(document, losses, name, options);
    } catch (const Failure& failure) {
        refuse(name, failure.what());
    }
}

Imported made_of(const art::Document& document, const std::string& name, const Options& options,
                 const art::Losses& losses)
{
    options.on_progress(steps_to_read, steps);
    Draft draft = named_draft_of(document, losses, name, options);
    options.on_progress(steps_to_write, steps);
    Imported imported;
    imported.text = std::move(draft.written.text);
    if (imported.text.size() > max_scene_text_bytes)
        refuse(name,
               "makes a scene text larger than 4 MB, more than kfast reads: draw less, or raise --tolerance");
    imported.compiled = compiled(name, imported.text, options.on_progress);
    imported.extent = extent_of(draft.document);
    imported.losses = std::move(draft.losses);
    return imported;
}

/// What is known of a file once it is read.
struct ReadFile {
    art::Document document;
    art::Losses losses;
    Notes notes;
};

ReadFile read_file(const SourceText& source, const Options& options, lottie::Repeated repeated)
{
    ReadFile file;
    file.document = read(source, options, repeated, file.losses, file.notes);
    if (options.background)
        put_behind(file.document, *options.background);
    return file;
}

Imported made_of(const ReadFile& file, const std::string& name, const Options& options)
{
    Imported imported = made_of(file.document, name, options, file.losses);
    imported.notes = file.notes;
    return imported;
}

/// Halves of the progress, for what is made in two ways.
Options first_half(Options options)
{
    options.on_progress = [whole = options.on_progress](std::size_t done, std::size_t total) {
        whole(done, 2 * total);
    };
    return options;
}

Options second_half(Options options)
{
    options.on_progress = [whole = options.on_progress](std::size_t done, std::size_t total) {
        whole(total + done, 2 * total);
    };
    return options;
}

/// What `make` returns; nothing where it throws Failure, unless that is a mistake.
template <typename Make>
auto attempted(const Make& make) -> std::optional<decltype(make())>
{
    try {
        return make();
    } catch (const Mistake&) {
        throw;
    } catch (const Failure&) {
        return std::nullopt;
    }
}

/// A scene that holds what is repeated as symbols, or, where that is smaller or the only one within all
/// limits, written out.
Imported smaller_of(const std::optional<ReadFile>& with_symbols, const SourceText& source,
                    const Options& options)
{
    std::optional<Imported> symbols;
    if (with_symbols)
        symbols = attempted([&] { return made_of(*with_symbols, source.name, first_half(options)); });
    const auto write_out = [&] {
        return made_of(read_file(source, options, lottie::Repeated::written_out), source.name,
                       second_half(options));
    };
    if (!symbols)
        return write_out();
    auto copies = attempted(write_out);
    const bool is_smaller = copies && copies->compiled.bytes.size() < symbols->compiled.bytes.size();
    return std::move(is_smaller ? *copies : *symbols);
}

}

Imported import_scene(const std::string& name, std::string content, const Options& options)
{
    const SourceText source{name, unpacked(name, std::move(content))};
    const auto kind = kind_of(source.text);
    if (kind != ContentKind::json && kind != ContentKind::zip)
        return made_of(read_file(source, options, lottie::Repeated::written_out), name, options);
    const auto file = attempted([&] { return read_file(source, options, lottie::Repeated::as_symbols); });
    if (file && file->document.symbols.empty())
        return made_of(*file, name, options);
    return smaller_of(file, source, options);
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
    Notes notes;
    const art::Document document =
        on_paper(svg::read_svg_keys(drawings, times, options.drawings, losses, notes), options);
    const std::string name = drawings.empty() ? "" : drawings.front().name;
    Imported imported = made_of(document, name, options, losses);
    imported.notes = std::move(notes);
    return imported;
}

}
