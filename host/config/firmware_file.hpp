#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

namespace kfast::config {

/// The .bin of a firmware for the Pico: what lies from the beginning of its flash on, a boot block first.
/// Throws Failure when it cannot be read, has no boot block with the right checksum, or would reach into the
/// settings.
std::vector<std::byte> load_firmware(const std::filesystem::path& path);

}
