#pragma once

#include "host/commands/inputs/input_values.hpp"
#include "host/commands/options/play_options.hpp"
#include "host/commands/render/audio_options.hpp"
#include "host/commands/render/picture_options.hpp"
#include "host/preview/viewer/opened_scene.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <ostream>
#include <string>

namespace kfast {

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
    /// CLI::ValidationError if the scene has not what the options name.
    ///
    /// If its text has mistakes, it is asked whether somebody watches who may mend them: for that one an
    /// empty scene is opened, of which OpenedScene::mistakes tells them.
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
