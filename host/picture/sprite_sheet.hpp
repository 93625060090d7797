#pragma once

#include "host/picture/frame_source.hpp"
#include "host/picture/timeline.hpp"
#include "host/program/progress_callback.hpp"

#include <filesystem>

namespace kfast {

/// The file beside a sprite sheet that lists where its pictures are.
std::filesystem::path sprite_list_path(const std::filesystem::path& sheet);

struct SpriteSheetForm {
    int columns = 1;           ///< pictures in a row, at least 1
    bool has_way_back = false; ///< for ping-pong, which otherwise has every picture once, including both ends
};

/// What has been written.
struct SpriteSheet {
    std::size_t pictures = 0;
    Size size;
};

/// Writes every frame of what is played, row by row on one PNG; and beside it, at sprite_list_path(), where
/// each of them is, for how long it is shown, and how the list is to be played. Throws Failure when one
/// cannot be written, or when the sheet has more pixels than the maximum of pictures.
SpriteSheet write_sprite_sheet(const std::filesystem::path& target, FrameSource& source,
                               const Timeline& timeline, const SpriteSheetForm& form,
                               const ProgressCallback& on_progress = ignore_progress);

}
