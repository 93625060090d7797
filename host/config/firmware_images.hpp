#pragma once

#include "firmware/settings/board_settings.hpp"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace kfast::config {

/// The folders in which images of the Pico may lie, the first one first: the one that `given` names, and no
/// other then; else `share/kfast/firmware` of the installation, or `build/pico` of the build tree, that the
/// program belongs to (nothing if its place is not known).
std::vector<std::filesystem::path> image_folders(const char* given,
                                                 const std::optional<std::filesystem::path>& program);

/// Of this program, told by the environment's KFAST_FIRMWARE.
std::vector<std::filesystem::path> image_folders();

/// The firmware for displays on this bus. Throws Failure, naming the folders, if none of them has it.
std::filesystem::path image_for(BusKind bus, std::span<const std::filesystem::path> folders);

/// What to call it before a person: its place in the first of the folders, which is where it is installed, or
/// if it is not there, where scripts/build puts it: "build/pico/pico-spi.bin".
std::string image_of(BusKind bus, std::span<const std::filesystem::path> folders);

/// For this program.
std::string image_of(BusKind bus);

}
