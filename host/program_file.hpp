#pragma once

#include <filesystem>
#include <optional>

namespace kfast {

/// The file by which this program was started: `executable`, what /proc/self/exe leads to. If that is not
/// known, or is a dynamic loader that was given a program to load, as the launcher of the portable tar does
/// (packages/portable/launcher.c), it is `invocation`, argv[0] of the program, which the launcher sets to its
/// own path. Nothing if that is not a whole path.
std::optional<std::filesystem::path> program_file(const std::optional<std::filesystem::path>& executable,
                                                  const std::filesystem::path& invocation);

/// Of this program.
std::optional<std::filesystem::path> program_file();

/// Whether this program runs with libraries of its own, as the portable tar has them, instead of the
/// computer's. Those that are loaded later by name, such as drivers of graphics cards, need not fit them.
bool has_own_libraries();

}
