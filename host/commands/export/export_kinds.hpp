#pragma once

#include "core/beam/beam_profile.hpp"
#include "host/commands/options/beam_options.hpp"
#include "host/commands/options/play_options.hpp"
#include "host/commands/render/picture_options.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace kfast {

/// What kfast export was asked for, of any kind of file.
struct ExportOptions {
    std::string scene;
    std::string output;
    std::optional<std::string> name;
    PictureOptions picture;
    PlayOptions play;
    std::optional<BeamProfile> beam;
    int ilda_format = 5;
    int bits = 16;
    std::optional<double> seconds; ///< none: one play
    SoundOptions sound;
    bool quiet = false;
};

/// Where to: as chosen, else the scene's name with this ending.
std::filesystem::path export_path(const ExportOptions& options, const char* ending);

/// `name`, if it can be the name of an array in C and in C++, also with a few letters after it; else throws
/// CLI::ValidationError for the option --array-name.
const std::string& checked_c_name(const std::string& name);

void export_header(const ExportOptions& options);
void export_ilda(const ExportOptions& options);
void export_wave(const ExportOptions& options);

}
