#pragma once

#include "host/flash/flash_image.hpp"
#include "host/flash/flashing.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace kfast {

/// Where file systems are mounted that a drive which is plugged in may have, as /proc/self/mountinfo tells
/// it. No network is asked.
std::vector<std::filesystem::path> mounted_folders(std::string_view mountinfo);

/// A mounted drive of a boot loader. It takes UF2 files and tells nothing of what lies in flash.
struct Uf2Drive {
    std::filesystem::path folder;
    std::string board; ///< Board-ID of its INFO_UF2.TXT: "RPI-RP2"
};

/// Those that are mounted: what has an INFO_UF2.TXT.
std::vector<Uf2Drive> uf2_drives();

/// The drive whose folder that is. Throws Failure with no_device if it is none, with wrong_chip if it is not
/// that of an RP2040.
Uf2Drive uf2_drive_at(const std::filesystem::path& folder);

/// Copies `image` to the drive in such an order that a board on which it was broken off starts nothing. The
/// board restarts by itself then; nothing is verified, and whether it had the last bytes nobody knows before
/// it answers.
///
/// Throws Failure with unplugged, with no_permission or wrong_input if the drive takes no file, and
/// Interrupted.
void copy_to_drive(const Uf2Drive& drive, const FlashImage& image, const FlashProgressCallback& on_progress);

}
