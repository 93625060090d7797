#pragma once

#include "core/beam/beam_profile.hpp"
#include "host/beam/profile_choice.hpp"

#include <CLI/CLI.hpp>
#include <optional>

namespace kfast {

/// Adds --beam. `beam` must outlive the parsing.
CLI::Option* declare_beam_option(CLI::App& app, std::optional<BeamProfile>& beam);
CLI::Option* declare_beam_option(CLI::App& app, std::optional<ChosenBeam>& beam);

}
