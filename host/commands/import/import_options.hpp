#pragma once

#include "host/compile/scene_file.hpp"

#include <CLI/CLI.hpp>

namespace kfast {

/// What load_scene() takes, for the help.
inline constexpr const char* loaded_scene =
    "A scene text (.kfast), a compiled scene (.kfb), or a file to import (.json, .lottie, .svg, .sif)";

/// --tolerance, --canvas, --background, --animation and --strict, for commands that may load a file of
/// another program.
void declare_import_options(CLI::App& app, ImportChoice& choice);

}
