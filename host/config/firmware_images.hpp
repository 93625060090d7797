#pragma once

#include "firmware/settings/board_settings.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace kfast::config {

/// The folders in which images of the Pico may be, in the order of the search: only the one that `given`
/// names; else `share/kfast/firmware` of the installation, or `build/pico` of the build tree, that the
/// program belongs to (nothing if its path is not known).
std::vector<std::filesystem::path> image_folders(const char* given,
                                                 const std::optional<std::filesystem::path>& program);

/// Those of this program, with the environment's KFAST_FIRMWARE as `given`.
std::vector<std::filesystem::path> image_folders();

/// The firmware for displays on this bus. Throws Failure, naming the folders, if none of them has it.
std::filesystem::path image_for(BusKind bus, std::span<const std::filesystem::path> folders);

/// Its path for messages: in the first of the folders, which is where it is installed, or if it is not
/// there, where scripts/build puts it: "build/pico/pico-spi.bin".
std::string image_of(BusKind bus, std::span<const std::filesystem::path> folders);

/// For this program.
std::string image_of(BusKind bus);

/// The .bin of a firmware for the Pico: the contents from the beginning of its flash on, a boot block first.
/// Throws Failure when it cannot be read, has no boot block with the right checksum, or is shorter or longer
/// than it says; with no_room when it would reach into the settings.
std::vector<std::byte> load_firmware(const std::filesystem::path& path);

/// Whether they begin with a boot block of the RP2040, with the right checksum.
bool begins_with_boot_block(std::span<const std::byte> bytes);

/// The bus that an image says it is for (firmware/settings/image_mark.hpp); nothing if it says nothing.
std::optional<BusKind> marked_bus(std::span<const std::byte> image);

}
