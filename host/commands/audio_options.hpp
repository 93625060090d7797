#pragma once

#include "core/beam/beam_profile.hpp"
#include "host/commands/picture_options.hpp"
#include "host/commands/sound_options.hpp"

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

/// What is drawn by `picture` and, if it is to be heard, led along by a sound card too. A profile other than
/// the usual one has its rate changed to that of the sound. `scene` must outlive the source. Throws Failure
/// where there is no such sound card.
std::unique_ptr<FrameSource> heard(std::unique_ptr<FrameSource> picture, const AudioOptions& options,
                                   const std::optional<BeamProfile>& beam, const PictureOptions& inputs,
                                   const SceneFile& scene);

}
