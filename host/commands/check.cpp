#include "host/commands/command.hpp"
#include "host/commands/import/import_options.hpp"
#include "host/commands/info/check_json.hpp"
#include "host/commands/options/option_facts.hpp"
#include "host/commands/options/output_options.hpp"
#include "host/commands/text/summary.hpp"
#include "host/compile/scene_file.hpp"
#include "host/file/input_file.hpp"
#include "host/import/loss_list.hpp"
#include "host/preview/overlay/unseen_objects.hpp"
#include "host/program/failure.hpp"
#include "host/text/number_text.hpp"
#include "host/text/reported_diagnostics.hpp"

#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace kfast {
namespace {

constexpr const char* standard_input = "-";

struct CheckOptions {
    std::vector<std::string> paths;
    std::string name = "<stdin>"; ///< of what comes from standard input
    bool json = false;
    ImportChoice import_choice{.on_loss = OnLoss::report};
};

std::string name_of(const std::string& path, const CheckOptions& options)
{
    return path == standard_input ? options.name : path;
}

std::string content_of(const std::string& path, const CheckOptions& options)
{
    if (path != standard_input)
        return read_input(path, scene_input);
    std::string content{std::istreambuf_iterator{std::cin}, {}};
    return content.empty() ? throw Failure(options.name + ": nothing came from standard input") : content;
}

/// Warns of objects in a scene text that are never seen.
void warn_of_unseen(const SceneFile& scene, Diagnostics& diagnostics)
{
    if (scene.item_places.empty())
        return;
    for (const UnseenObject& object : unseen_objects(scene.view))
        diagnostics.warning(scene.item_places[object.number], "on a panel, no frame shows anything of this",
                            object.is_hidden
                                ? "it is hidden or transparent all the time"
                                : "it is outside of the canvas all the time, or has no area, or its trim or "
                                  "dashes leave nothing of it");
}

void check_scene(const std::string& path, const CheckOptions& options)
{
    const SourceText source{name_of(path, options), content_of(path, options)};
    const SceneFile scene = scene_of(source.name, source.text, options.import_choice, printing_to(std::cerr));
    Diagnostics unseen;
    warn_of_unseen(scene, unseen);
    const std::size_t warnings = scene.warnings + report(unseen, source).warnings;
    std::cout << source.name << ": ok: " << summary(scene) << ", " << counted(warnings, "warning") << '\n';
    if (!scene.losses.empty())
        std::cout << importing::loss_count(scene.losses) << ":\n"
                  << importing::loss_list(scene.losses, importing::ListLength::whole) << '\n';
}

[[noreturn]] void fail_of_several(std::size_t wrong, std::size_t all)
{
    throw Failure(std::to_string(wrong) + " of " + counted(all, "file") + (wrong == 1 ? " is" : " are") +
                  " wrong");
}

void check_as_text(const CheckOptions& options)
{
    if (options.paths.size() == 1)
        return check_scene(options.paths.front(), options);
    std::size_t wrong = 0;
    for (const std::string& path : options.paths)
        try {
            check_scene(path, options);
        } catch (const Failure& failure) {
            std::cerr << "kfast: " << failure.what() << '\n';
            ++wrong;
        }
    if (wrong > 0)
        fail_of_several(wrong, options.paths.size());
}

/// Losses are listed, whether they are allowed or not.
CheckedFile checked(const std::string& path, const CheckOptions& options)
{
    CheckedFile file{.name = name_of(path, options), .text = {}};
    try {
        file.text = content_of(path, options);
        const auto keep = [&file](const Diagnostics& found, const SourceText&) {
            file.diagnostics = found;
            return count(found);
        };
        ImportChoice choice = options.import_choice;
        choice.on_loss = OnLoss::report;
        const SceneFile scene = scene_of(file.name, file.text, choice, keep);
        file.summary = summary(scene);
        warn_of_unseen(scene, file.diagnostics);
        file.losses = scene.losses;
        if (options.import_choice.on_loss == OnLoss::refuse && !file.losses.empty())
            file.failure = file.name + ": " + importing::loss_count(file.losses);
    } catch (const Failure& failure) {
        if (!file.diagnostics.has_errors())
            file.failure = failure.what();
    }
    return file;
}

void check_as_json(const CheckOptions& options)
{
    std::vector<CheckedFile> files;
    for (const std::string& path : options.paths)
        files.push_back(checked(path, options));
    std::cout << check_json(files);
    const auto wrong = static_cast<std::size_t>(std::ranges::count(files, false, &CheckedFile::is_valid));
    if (wrong > 0)
        fail_of_several(wrong, files.size());
}

void require_one_input(const CheckOptions& options)
{
    const auto inputs = std::ranges::count(options.paths, standard_input);
    if (inputs > 1)
        throw CLI::ValidationError("SCENE", "standard input, -, can be read once");
    if (inputs == 0 && options.name != CheckOptions{}.name)
        throw CLI::ValidationError("--stdin-filename",
                                   "names what comes from standard input: write - as SCENE");
}

void declare_check(CLI::App& app)
{
    const auto options = std::make_shared<CheckOptions>();
    reads_scene(app.add_option("SCENE", options->paths,
                               std::string{loaded_scene} + "; several, or - for standard input"))
        ->required();
    reads_file(
        app.add_option("--stdin-filename", options->name,
                       "With -: the file that the text belongs to, for messages and for fonts beside it"))
        ->type_name("FILE");
    declare_json(app, options->json);
    declare_import_options(app, options->import_choice);
    app.callback([options] {
        require_one_input(*options);
        options->json ? check_as_json(*options) : check_as_text(*options);
    });
}

}

const Command check_command{"check", "Say what is wrong with a scene, without writing anything",
                            "kfast check eyes.kfast\n"
                            "  kfast check eyes.json --strict\n"
                            "  kfast check - --stdin-filename eyes.kfast --json < eyes.kfast",
                            declare_check};

}
