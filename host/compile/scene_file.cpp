#include "host/compile/scene_file.hpp"

#include "core/bytes/result.hpp"
#include "host/compile/reported_compile.hpp"
#include "host/file/input_file.hpp"
#include "host/import/content_kind.hpp"
#include "host/import/import_scene.hpp"
#include "host/import/loss_list.hpp"
#include "host/program/failure.hpp"
#include "host/scene/font/font_files.hpp"
#include "host/text/characters.hpp"
#include "host/text/number_text.hpp"
#include "host/text/reported_diagnostics.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <string_view>

namespace kfast {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view magic = "KFB";

[[noreturn]] void refuse(const fs::path& path, const std::string& reason)
{
    throw Failure(path.string() + ": " + reason);
}

std::string in_words(Error error, std::span<const std::byte> bytes)
{
    const std::string again = "compile the scene again";
    switch (error) {
    case Error::truncated:
        return "the compiled scene breaks off before its end: copy it again, or " + again;
    case Error::bad_magic:
        return "not a compiled scene: name " + std::string{scene_files};
    case Error::unsupported_version: {
        const int its = bytes.size() > magic.size() ? std::to_integer<int>(bytes[magic.size()]) : 0;
        return std::string("made by ") + (its > int{kfb::version} ? "a newer" : "another") +
               " kfast (format " + std::to_string(its) + ", this one reads " +
               std::to_string(int{kfb::version}) + "): update kfast, or " + again;
    }
    case Error::bad_checksum:
        return "the compiled scene was damaged on the way: copy it again, or " + again;
    case Error::bad_scene:
        return "the compiled scene contradicts itself: " + again;
    case Error::block_too_small:
        return "the scene needs more memory than it says: " + again;
    case Error::too_slow:
        return "a picture of the scene takes a Pico (RP2040) longer than a second: " +
               std::string{slow_scene_hint};
    default: // the command has all features
        return std::string{error_text(error)};
    }
}

SceneFile checked(const fs::path& path, std::vector<std::byte> bytes)
{
    const Result<SceneView> view = SceneView::parse(bytes);
    if (!view)
        refuse(path, in_words(view.error(), bytes));
    return {std::move(bytes), *view};
}

SceneFile from_bytes(const fs::path& path, std::span<const std::byte> bytes)
{
    return checked(path, {bytes.begin(), bytes.end()});
}

SceneFile from_text(const fs::path& path, std::string text, const Reporter& reporter)
{
    if (seems_utf16(text))
        refuse(path, "the text is in UTF-16: save it as UTF-8");
    if (text.find('\0') != std::string::npos)
        refuse(path, "neither a scene nor a compiled scene: name " + std::string{scene_files});
    if (text.size() > max_scene_text_bytes)
        refuse(path, "a text larger than 4 MB, more than any scene needs: is it the right file?");
    SourceText source{path.string(), std::move(text), path.parent_path().string()};
    CompiledText compiled = compile_and_report(source, reporter);
    if (!compiled.bytes)
        refuse(path, counted(compiled.errors, "error"));
    SceneFile scene = checked(path, std::move(*compiled.bytes));
    scene.was_text = true;
    scene.warnings = compiled.warnings;
    scene.item_names = std::move(compiled.item_names);
    scene.item_places = std::move(compiled.item_places);
    scene.other_names = std::move(compiled.other_names);
    scene.fonts = scene::font_files(source);
    scene.text = std::move(source.text);
    return scene;
}

void report_losses(const fs::path& path, const art::Losses& losses, OnLoss on_loss, std::ostream& out)
{
    if (losses.empty() || on_loss == OnLoss::report)
        return;
    const std::string number = importing::loss_count(losses);
    if (on_loss == OnLoss::refuse)
        refuse(path, number + ":\n" + importing::loss_list(losses, importing::ListLength::cut));
    print_warning(path.string(), number + ": 'kfast check " + path.string() + "' lists them", out);
}

SceneFile from_other_program(const fs::path& path, std::string content, const ImportChoice& choice,
                             std::ostream& out)
{
    importing::Imported imported = importing::import_scene(path.string(), std::move(content), choice.options);
    report_losses(path, imported.losses, choice.on_loss, out);
    SceneFile scene = checked(path, std::move(imported.compiled.bytes));
    scene.was_text = true;
    scene.item_names = std::move(imported.compiled.item_names);
    scene.other_names = std::move(imported.compiled.other_names);
    scene.losses = std::move(imported.losses);
    return scene;
}

SceneFile read_scene(const fs::path& path, std::string content, const ImportChoice& choice,
                     const Reporter& reporter, std::ostream& out)
{
    if (importing::can_import(content))
        return from_other_program(path, std::move(content), choice, out);
    SceneFile scene = content.starts_with(magic) ? from_bytes(path, std::as_bytes(std::span{content}))
                                                 : from_text(path, std::move(content), reporter);
    if (!choice.only_for_imports.empty())
        throw Failure(path.string() + ": " + choice.only_for_imports +
                          " is for files of other programs, and this is a scene of kfast: leave it out",
                      ExitStatus::wrong_usage);
    return scene;
}

}

SceneFile load_scene(const fs::path& path, const ImportChoice& choice, std::ostream& out)
{
    return scene_of(path, read_input(path, scene_input), choice, printing_to(out), out);
}

SceneFile scene_of(const fs::path& path, std::string content, const ImportChoice& choice,
                   const Reporter& reporter, std::ostream& out)
{
    return read_scene(path, std::move(content), choice, reporter, out);
}

}
