#pragma once

#include "host/sound/deflection.hpp"

#include <CLI/CLI.hpp>
#include <cstdint>
#include <vector>

namespace kfast {

/// How a sound card leads a beam, as chosen by --sample-rate, --swap, --mirror and --gain.
struct SoundOptions {
    std::uint32_t rate = 48'000; ///< samples in a second
    Deflection deflection;
};

/// Adds these options to `app`, and returns them. `options` must outlive its parsing.
std::vector<CLI::Option*> declare_sound_options(CLI::App& app, SoundOptions& options);

}
