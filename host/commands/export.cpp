#include "host/atomic_file.hpp"
#include "host/commands/c_name.hpp"
#include "host/commands/command.hpp"
#include "host/commands/output_path.hpp"
#include "host/commands/picture_options.hpp"
#include "host/commands/scene_header.hpp"
#include "host/commands/summary.hpp"
#include "host/scene_file.hpp"

#include <iostream>
#include <span>

namespace kfast {
namespace {

namespace fs = std::filesystem;

struct ExportOptions {
    std::string scene;
    std::string output;
    std::optional<std::string> name;
    PictureOptions picture;
};

fs::path chosen_output(const ExportOptions& options)
{
    return options.output.empty() ? fs::path{options.scene}.replace_extension(".h")
                                  : fs::path{options.output};
}

void export_scene(const ExportOptions& options)
{
    const std::string name = options.name ? *options.name : c_name_for(options.scene);
    const SceneFile scene = load_scene(options.scene);
    const fs::path output = output_path(chosen_output(options), options.scene);
    const SceneHeader header{name, fs::path{options.scene}.filename().string(),
                             panel_size(options.picture, scene.view)};
    const std::string text = header_text(header, scene);
    write_file(output, std::as_bytes(std::span{text}));
    std::cout << output.string() << ": " << name << "[], "
              << summary(scene, header.panel, block_bytes(header, scene)) << '\n';
}

void declare(CLI::App& app)
{
    const auto options = std::make_shared<ExportOptions>();
    app.add_option("FILE", options->scene, "A scene text (.kfast) or compiled scene (.kfb)")->required();
    app.add_flag("--header")->description("As an array in a header for C and C++")->required();
    app.add_option("-o,--output", options->output, "The header (default: FILE's name with .h)");
    app.add_option_function<std::string>(
           "--name", [options](const std::string& name) { options->name = checked_c_name(name); },
           "What the array is called (default: FILE's name)")
        ->type_name("NAME");
    declare_size_options(app, options->picture);
    app.callback([options] { export_scene(*options); });
}

}

const Command export_command{"export", "Turn a scene into source for programs in C and C++",
                             "kfast export --header eyes.kfast -o eyes.h", declare};

}
