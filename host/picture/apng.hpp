#pragma once

#include "host/picture/film.hpp"
#include "host/picture/frame_source.hpp"
#include "host/picture/timeline.hpp"
#include "host/program/progress_callback.hpp"

#include <filesystem>

namespace kfast {

/// Writes one period of what is played as an animated PNG that loops as the scene or clip does.
///
/// Colours are exact. Delays are fractions (FilmDelay): pictures that repeat become one, as long as its delay
/// stays exact, and of others only the rectangle that changes is stored. Throws Failure when the file cannot
/// be written or would be larger than `limit` allows; then there is none. Layout: APNG Specification,
/// wiki.mozilla.org/APNG_Specification.
void write_apng(const std::filesystem::path& target, FrameSource& source, const Timeline& timeline,
                const ProgressCallback& on_progress = ignore_progress, const FilmLimit& limit = {});

}
