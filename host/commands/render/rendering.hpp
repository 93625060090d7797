#pragma once

#include "host/commands/options/play_options.hpp"
#include "host/commands/render/picture_options.hpp"
#include "host/picture/frame_source.hpp"
#include "host/program/progress_callback.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace kfast {

/// What `kfast render` draws of a scene.
enum class RenderSubject { moment, film, sprite_sheet, contact_sheet };

/// The kinds of files that it makes of that.
enum class RenderKind { png, svg, folder, apng, gif, mp4, webm };

/// Chosen by the ending of `output`'s name; without one a single picture is a PNG, and a film is a folder.
/// Throws CLI::ValidationError, with a hint, for a name that is unknown or of another kind than the subject
/// can be.
RenderKind render_kind(const std::filesystem::path& output, RenderSubject subject);

/// The default: the film if such a file is an animation or a video, else a single picture.
RenderSubject default_subject(const std::filesystem::path& output);

constexpr bool is_video(RenderKind kind) { return kind == RenderKind::mp4 || kind == RenderKind::webm; }

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

/// What is to be done, after the options have been checked to fit each other.
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
