#pragma once

#include "firmware/settings/board_settings.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

namespace kfast::config {

/// The .bin of a firmware for the Pico: what lies from the beginning of its flash on, a boot block first.
/// Throws Failure when it cannot be read, has no boot block with the right checksum, or is shorter or longer
/// than it says; with no_room when it would reach into the settings.
std::vector<std::byte> load_firmware(const std::filesystem::path& path);

/// Whether they begin with a boot block of the RP2040, with the right checksum.
bool begins_with_boot_block(std::span<const std::byte> bytes);

/// The bus that an image says it is for (firmware/settings/image_mark.hpp); nothing if it says nothing.
std::optional<BusKind> marked_bus(std::span<const std::byte> image);

}
