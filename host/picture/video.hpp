#pragma once

#include "host/picture/frame_source.hpp"
#include "host/picture/timeline.hpp"
#include "host/program/progress_callback.hpp"

#include <filesystem>

namespace kfast {

enum class VideoKind { mp4, webm };

/// Whether a picture gets another column and row: H.264 as players know it has sides of even length.
bool is_padded(Size size);

/// Writes `loops` periods of what is played, at least one, by way of the program ffmpeg: H.264 in MP4, VP9 in
/// WebM, every frame of the scene as one of the video. A side of odd length becomes one pixel longer, like
/// its neighbour. Throws Failure when there is no ffmpeg, or with the last of what it tells when it fails;
/// then there is no file.
void write_video(const std::filesystem::path& target, VideoKind kind, FrameSource& source,
                 const Timeline& timeline, int loops, const ProgressCallback& on_progress = ignore_progress);

}
