#pragma once

#include "host/beam/profile_choice.hpp"
#include "host/commands/options/sound_options.hpp"
#include "host/sound/led_beam.hpp"

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>

namespace kfast {

/// Whether and how a preview is heard, as chosen by --audio, --audio-device and those of SoundOptions.
struct AudioOptions {
    bool is_heard = false;
    std::string device; ///< empty: the usual one
    SoundOptions sound;
};

/// Adds these options to `app`, and --audio-devices, which lists the devices and ends the program. `options`
/// must outlive its parsing. Returns --audio.
CLI::Option* declare_audio_options(CLI::App& app, AudioOptions& options);

/// What the sound card leads: by the profile of `beam`, if one was chosen, but at the rate of the sound.
BeamProfile heard_profile(const AudioOptions& audio, const std::optional<ChosenBeam>& beam);
/// Plays on. Throws Failure where there is no such sound card.
std::shared_ptr<LedBeam> opened_sound(const AudioOptions& audio, const BeamProfile& profile);

}
