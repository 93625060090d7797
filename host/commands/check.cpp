#include "host/commands/command.hpp"
#include "host/commands/import_options.hpp"
#include "host/commands/summary.hpp"
#include "host/counted.hpp"
#include "host/import/loss_list.hpp"
#include "host/scene_file.hpp"

#include <iostream>

namespace kfast {
namespace {

struct CheckOptions {
    std::string path;
    ImportChoice import_choice{.on_loss = OnLoss::report};
};

void check_scene(const CheckOptions& options)
{
    const SceneFile scene = load_scene(options.path, options.import_choice);
    std::cout << options.path << ": ok: " << summary(scene) << ", " << counted(scene.warnings, "warning")
              << '\n';
    if (!scene.losses.empty())
        std::cout << importing::loss_count(scene.losses) << ":\n"
                  << importing::loss_list(scene.losses, importing::ListLength::whole) << '\n';
}

void declare(CLI::App& app)
{
    const auto options = std::make_shared<CheckOptions>();
    app.add_option("SCENE", options->path, loaded_scene)->required();
    declare_import_options(app, options->import_choice);
    app.callback([options] { check_scene(*options); });
}

}

const Command check_command{"check", "Say what is wrong with a scene, without writing anything",
                            "kfast check eyes.kfast\n"
                            "  kfast check eyes.json --strict",
                            declare};

}
