#pragma once

#include "core/beam/beam_profile.hpp"
#include "host/beam/profile_choice.hpp"
#include "host/sound/deflection.hpp"

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <vector>

namespace kfast {

/// Adds --beam. `beam` must outlive the parsing.
CLI::Option* declare_beam_option(CLI::App& app, std::optional<BeamProfile>& beam);
CLI::Option* declare_beam_option(CLI::App& app, std::optional<ChosenBeam>& beam);

/// How a sound card drives a beam, as chosen by --sample-rate, --swap, --mirror and --gain.
struct SoundOptions {
    std::uint32_t rate = 48'000; ///< samples in a second
    Deflection deflection;
};

/// Adds these options to `app`, and returns them. `options` must outlive its parsing.
std::vector<CLI::Option*> declare_sound_options(CLI::App& app, SoundOptions& options);

}
