#include "host/commands/command.hpp"
#include "host/commands/summary.hpp"
#include "host/counted.hpp"
#include "host/scene_file.hpp"

#include <iostream>

namespace kfast {
namespace {

void check_scene(const std::string& path)
{
    const SceneFile scene = load_scene(path);
    std::cout << path << ": ok: " << summary(scene) << ", " << counted(scene.warnings, "warning") << '\n';
}

void declare(CLI::App& app)
{
    const auto path = std::make_shared<std::string>();
    app.add_option("SCENE", *path, "The scene text (.kfast) or compiled scene (.kfb)")->required();
    app.callback([path] { check_scene(*path); });
}

}

const Command check_command{"check", "Say what is wrong with a scene, without writing anything",
                            "kfast check eyes.kfast", declare};

}
