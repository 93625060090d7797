#pragma once

#include <filesystem>
#include <string>

namespace kfast {

/// What `kfast render` draws of a scene.
enum class RenderSubject { moment, film, sprite_sheet, contact_sheet };

/// The kinds of files that it makes of that.
enum class RenderKind { png, svg, folder, apng, gif, mp4, webm };

/// Chosen by the ending of `output`'s name; without one a moment is a PNG, and a film goes into a folder.
/// Throws CLI::ValidationError, with a hint, for a name that is unknown or of another kind than the subject
/// can be.
RenderKind render_kind(const std::filesystem::path& output, RenderSubject subject);

/// What is drawn if nothing is said of it: the film if such a file is an animation or a video, else a moment.
RenderSubject default_subject(const std::filesystem::path& output);

constexpr bool is_video(RenderKind kind) { return kind == RenderKind::mp4 || kind == RenderKind::webm; }

}
