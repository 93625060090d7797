#pragma once

#include <CLI/CLI.hpp>

namespace kfast {

/// How a command reports what it has done or found. The values must outlive the parsing of `app`.

/// Adds --json: to standard output goes JSON in place of the text.
CLI::Option* declare_json(CLI::App& app, bool& json);
/// Adds -q, --quiet: nothing is printed but errors, and warnings of what is wrong with a scene.
CLI::Option* declare_quiet(CLI::App& app, bool& quiet);

}
