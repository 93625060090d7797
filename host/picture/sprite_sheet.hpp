#pragma once

#include "host/picture/frame_source.hpp"
#include "host/picture/timeline.hpp"
#include "host/tell_work.hpp"

#include <filesystem>

namespace kfast {

/// The file beside a sprite sheet that tells where its pictures are.
std::filesystem::path sprite_list_path(const std::filesystem::path& sheet);

/// Every frame of what is played, row by row on one PNG of `columns` pictures a row, at least 1; and beside
/// it, at sprite_list_path(), where each of them lies and for how long it is shown. Throws Failure
/// when one cannot be written, or when the sheet has more pixels than pictures have.
void write_sprite_sheet(const std::filesystem::path& target, FrameSource& source, const Timeline& timeline,
                        int columns, const TellWork& tell = tell_nobody);

}
