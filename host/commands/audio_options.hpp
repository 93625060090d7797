#pragma once

#include "host/commands/picture_options.hpp"
#include "host/commands/sound_options.hpp"

#include <CLI/CLI.hpp>
#include <memory>
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

/// What is drawn by `picture`, opened with `options`, and, if it is to be heard, led along by a sound card
/// too: by the profile that was chosen, if one was, but at the rate of the sound. `scene` must outlive the
/// source. Throws Failure where there is no such sound card.
std::unique_ptr<FrameSource> heard(std::unique_ptr<FrameSource> picture, const AudioOptions& audio,
                                   const PictureOptions& options, const SceneFile& scene);

}
