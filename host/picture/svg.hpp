#pragma once

#include "host/file/atomic_file.hpp"
#include "host/picture/film.hpp"
#include "host/picture/svg_source.hpp"
#include "host/picture/timeline.hpp"
#include "host/program/progress_callback.hpp"

#include <filesystem>

namespace kfast {

/// Writes the picture at one time as an SVG, as large as the panel. Throws Failure when the file cannot be
/// written; then there is none.
void write_svg(const std::filesystem::path& target, SvgSource& source, Time moment, Sync sync = Sync::now);

/// Writes one period of what is played as one SVG whose frames appear one after the other (SMIL), and which
/// loops as the scene or clip does. Frames that repeat are stored once. Throws Failure as write_svg(), and
/// when it would be larger than `limit` allows.
void write_animated_svg(const std::filesystem::path& target, SvgSource& source, const Timeline& timeline,
                        const ProgressCallback& on_progress = ignore_progress, const FilmLimit& limit = {});

}
