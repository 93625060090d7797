#pragma once

#include "host/flash/flash_image.hpp"
#include "host/flash/flashing.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace kfast {

/// The mounts of file systems that a drive which is plugged in may have, from /proc/self/mountinfo.
/// No network is asked.
std::vector<std::filesystem::path> mounted_folders(std::string_view mountinfo);

/// A mounted drive of a boot loader. It takes UF2 files and does not show what is in flash.
struct Uf2Drive {
    std::filesystem::path folder;
    std::string board; ///< Board-ID of its INFO_UF2.TXT: "RPI-RP2"
};

/// The drives that are mounted: folders with an INFO_UF2.TXT.
std::vector<Uf2Drive> uf2_drives();

/// The drive with that folder. Throws Failure with no_device if it is none, with wrong_chip if it is not
/// that of an RP2040.
Uf2Drive uf2_drive_at(const std::filesystem::path& folder);

/// Copies `image` to the drive in such an order that a board on which it was interrupted starts nothing. The
/// board restarts by itself then; nothing is verified, and whether it has got the last bytes is not known
/// before it answers.
///
/// Throws Failure with unplugged, with no_permission or wrong_input if the drive takes no file, and
/// Interrupted.
void copy_to_drive(const Uf2Drive& drive, const FlashImage& image, const FlashProgressCallback& on_progress);

}
