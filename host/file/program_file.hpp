#pragma once

#include <filesystem>
#include <optional>

namespace kfast {

/// Returns the file by which this program was started. That is `executable`, what /proc/self/exe leads to, or
/// nothing if that is not known. If it is a dynamic loader, to which the launcher of the portable tar has
/// given the program (packages/portable/launcher.c), or is not known, the file is `invocation`, argv[0] of
/// the program, which the launcher sets to its own path. Returns nothing if that is not absolute.
std::optional<std::filesystem::path> program_file(const std::optional<std::filesystem::path>& executable,
                                                  const std::filesystem::path& invocation);

/// Returns that file of the running program.
std::optional<std::filesystem::path> program_file();

/// Whether this program runs with libraries of its own, as the portable tar has them, instead of the
/// computer's. Those that are loaded later by name, such as drivers of graphics cards, need not fit them.
bool has_own_libraries();

}
