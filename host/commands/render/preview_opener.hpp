#pragma once

#include "host/beam/profile_choice.hpp"
#include "host/commands/inputs/input_options.hpp"
#include "host/commands/options/beam_options.hpp"
#include "host/commands/options/play_options.hpp"
#include "host/commands/render/picture_options.hpp"
#include "host/preview/viewer/opened_scene.hpp"
#include "host/sound/beam_sound.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <ostream>
#include <string>

namespace kfast {

/// Whether and how a preview is heard, as chosen by --audio, --audio-device and those of SoundOptions.
struct AudioOptions {
    bool is_heard = false;
    std::string device; ///< empty: the default one
    SoundOptions sound;
};

/// Adds these options to `app`, and --audio-devices, which lists the devices and ends the program. `options`
/// must outlive its parsing. Returns --audio.
CLI::Option* declare_audio_options(CLI::App& app, AudioOptions& options);

/// The profile of what the sound card drives: that of `beam`, if chosen, but at the rate of the sound.
BeamProfile heard_profile(const AudioOptions& audio, const std::optional<ChosenBeam>& beam);
/// It keeps playing. Throws Failure if there is no such sound card.
std::shared_ptr<LedBeam> opened_sound(const AudioOptions& audio, const BeamProfile& profile);

/// How a preview opens scenes.
struct PreviewChoice {
    PlayOptions play;
    PictureOptions picture;
    AudioOptions audio;
    std::optional<std::filesystem::path> beside; ///< a folder, as PanelPictures
    std::optional<std::string> board; ///< with the display that is shown, where no other one is named
};

/// Opens scenes for a preview. Each file is read once for each time that a scene is opened, so that pipes can
/// be read; the sound card is opened with the first scene and plays on for all.
class PreviewOpener {
public:
    explicit PreviewOpener(PreviewChoice choice);

    /// The file that the command names: what is found is printed to standard error. Throws Failure, and
    /// CLI::ValidationError if the scene does not have what the options name.
    ///
    /// If its text has mistakes, the caller is asked whether somebody watches who may correct them: then an
    /// empty scene is opened, whose OpenedScene::mistakes has them.
    std::unique_ptr<OpenedScene> open_first(
        const std::filesystem::path& file, const std::function<bool()>& is_watched = [] { return false; });
    /// Any file after it, as Opener. What --clip, --input and --drawing name, which are about that one, is
    /// left out where the scene has no such name; its warnings say so.
    std::unique_ptr<OpenedScene> open_next(const std::filesystem::path& file);

private:
    struct Reading;

    std::unique_ptr<OpenedScene> opened(const PreviewChoice& choice, SceneFile scene, Reading& reading);
    std::unique_ptr<OpenedScene> empty(std::string mistakes, Reading& reading);
    std::unique_ptr<FrameSource> heard(std::unique_ptr<FrameSource> picture, const PictureOptions& options,
                                       const InputValues& inputs, const SceneView& scene);

    PreviewChoice choice_;
    std::shared_ptr<LedBeam> sound_;
    BeamProfile sound_profile_; ///< of `sound_`
};

}
