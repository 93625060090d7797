#pragma once

#include "host/art/animation/ease.hpp"
#include "host/compile/scene_file.hpp"

#include <CLI/CLI.hpp>
#include <string>

namespace kfast {

/// "constant", "hold", "ease-in-out", "bezier(0.42,0,0.58,1)": those laws of the scene language that
/// importers know. Throws CLI::ValidationError in the name of `option`.
art::Ease read_ease(const std::string& option, const std::string& text);

/// What load_scene() takes, for the help.
inline constexpr const char* loaded_scene =
    "A scene text (.kfast), a compiled scene (.kfb), or a file to import (.json, .lottie, .svg, .sif)";

/// Says that `option` names such a file (option_facts.hpp), and returns it.
CLI::Option* reads_scene(CLI::Option* option);

/// --tolerance, --canvas, --background, --animation and --strict, for commands that may load a file of
/// another program.
void declare_import_options(CLI::App& app, ImportChoice& choice);

}
