#pragma once

#include "host/picture/film.hpp"
#include "host/picture/frame_source.hpp"
#include "host/picture/timeline.hpp"
#include "host/program/progress_callback.hpp"

#include <filesystem>

namespace kfast {

/// Writes one period of what is played as an animated GIF that loops as the scene or clip does.
///
/// Colours are exact when there are at most 256 in all or in a frame; a frame with more is quantized, without
/// dither. Throws Failure when the file cannot be written or would be larger than `limit` allows; then there
/// is none.
void write_gif(const std::filesystem::path& target, FrameSource& source, const Timeline& timeline,
               const ProgressCallback& on_progress = ignore_progress, const FilmLimit& limit = {});

}
