#pragma once

#include "host/commands/options/play_options.hpp"
#include "host/commands/render/picture_options.hpp"
#include "host/commands/render/render_kind.hpp"
#include "host/picture/frame_source.hpp"
#include "host/program/progress_callback.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace kfast {

/// What kfast render was asked for.
struct RenderOptions {
    std::string file;
    std::string output;
    std::optional<int> frame;
    std::optional<std::string> time;
    bool all = false;
    bool contact = false;
    std::optional<int> columns; ///< of a sprite sheet
    bool has_way_back = false;  ///< as above
    std::string kind;           ///< of the files in a folder
    int scale = 1;
    std::optional<int> loops;
    bool quiet = false;
    PlayOptions play;
    PictureOptions picture;
    bool is_format_given = false;
};

/// What is to be done, when all options are known to fit each other.
struct Rendering {
    const RenderOptions& options;
    const SceneFile& scene;
    Timeline timeline;
    std::filesystem::path output;
    ProgressCallback on_progress;
};

/// What has been written.
struct Rendered {
    std::string contents; ///< "76 frames"
    Size size;
    std::uintmax_t bytes;
    Detail min_detail = Detail::full;
};

/// Whether that has outlines, and no pixels.
bool is_vector(const RenderOptions& options, RenderKind kind);

/// Writes what was asked for. Throws Failure if it cannot be written, and CLI::ValidationError for what the
/// scene does not have.
Rendered render_subject(const Rendering& job, RenderSubject subject, RenderKind kind);

}
