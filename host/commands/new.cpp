#include "host/commands/command.hpp"
#include "host/commands/options/named_choice.hpp"
#include "host/commands/options/offered_names.hpp"
#include "host/commands/options/report_options.hpp"
#include "host/commands/templates/template_list.hpp"
#include "host/file/atomic_file.hpp"
#include "host/preview/terminal/borrowed_terminal.hpp"
#include "host/program/failure.hpp"

#include <filesystem>
#include <iostream>
#include <span>

namespace kfast {
namespace {

namespace fs = std::filesystem;

struct NewOptions {
    std::string path;
    std::string_view text = starter_scene;
    bool list = false;
    bool json = false;
    bool force = false;
    bool quiet = false;
};

void require_free(const fs::path& path)
{
    std::error_code ignored;
    if (fs::symlink_status(path, ignored).type() != fs::file_type::not_found)
        throw Failure{path.string() + " exists already; choose another name, or replace it by --force"};
}

void write_scene(const NewOptions& options)
{
    const fs::path path = options.path;
    if (path.empty())
        throw CLI::RequiredError("SCENE");
    if (path.extension() != ".kfast")
        throw Failure{path.string() + ": the name of a scene text ends in .kfast"};
    if (!options.force)
        require_free(path);
    write_file(path, std::as_bytes(std::span{options.text}));
    report_stream(options.quiet) << path.string() << ": a scene to start from; see it with: kfast preview "
                                 << path.string() << '\n';
}

void print_list(bool as_json)
{
    const auto templates = scene_templates();
    if (as_json) {
        std::cout << template_json(templates);
        return;
    }
    if (can_play_in_terminal())
        std::cout << template_pictures(templates);
    std::cout << template_lines(templates);
}

void declare_new(CLI::App& app)
{
    const auto options = std::make_shared<NewOptions>();
    CLI::Option* const path = app.add_option("SCENE", options->path, "The scene text to write (.kfast)");
    CLI::Option* const like = app.add_option_function<std::string>(
        "--like",
        [options](const std::string& name) { options->text = named(scene_templates(), "--like", name).text; },
        "Begin with this scene of the gallery (docs/gallery.md) in place of a first small one");
    offer_names(like->type_name("NAME"), scene_templates());
    CLI::Option* const force = app.add_flag("--force", options->force, "Replace a file of that name");
    CLI::Option* const list =
        app.add_flag("--list", options->list, "Show the scenes of the gallery, in a terminal with pictures");
    list->excludes(path)->excludes(like)->excludes(force);
    declare_json(app, options->json)->needs(list);
    declare_quiet(app, options->quiet);
    app.callback([options] { options->list ? print_list(options->json) : write_scene(*options); });
}

}

const Command new_command{"new", "Write a small scene with comments, to start from",
                          "kfast new eyes.kfast\n"
                          "  kfast new dial.kfast --like gauge\n"
                          "  kfast new --list",
                          declare_new};

}
