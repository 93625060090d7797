#pragma once

#include "host/commands/audio_options.hpp"
#include "host/commands/picture_options.hpp"
#include "host/commands/play_options.hpp"
#include "host/preview/opened_scene.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace kfast {

/// How a preview opens scenes.
struct PreviewChoice {
    PlayOptions play;
    PictureOptions picture;
    AudioOptions audio;
    std::optional<std::string> board; ///< of the fit report
};

/// The file that the command names: what is found is printed to standard error. Throws Failure, and
/// CLI::ValidationError if the scene has not what the options name.
std::unique_ptr<OpenedScene> open_preview(const PreviewChoice& choice, const std::filesystem::path& file);

/// For all files after it. --clip, --input and --drawing, which are about that one, are left out where they
/// do not suit; the warnings of the scene say so.
Opener preview_opener(const PreviewChoice& choice);

}
