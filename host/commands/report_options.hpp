#pragma once

#include "core/size.hpp"

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <string>

namespace kfast {

/// How a command reports what it has done or found. The values must outlive the parsing of `app`.

/// Adds --json: to standard output goes JSON in place of the text.
CLI::Option* declare_json(CLI::App& app, bool& json);
/// Adds -q, --quiet: nothing is printed but errors, and warnings of what is wrong with a scene.
CLI::Option* declare_quiet(CLI::App& app, bool& quiet);

/// Where a command reports what it has written: standard output, or nowhere if it is to be quiet.
std::ostream& report_stream(bool quiet);

/// "310 bytes", "110 KB", "1.2 MB", of 1000 bytes each as in lists of files.
std::string file_size_text(std::uintmax_t bytes);

/// The size of a file that has been written; 0 of what is no file, such as a device.
std::uintmax_t written_bytes(const std::filesystem::path& file);

/// What is printed when pictures have been written to a file or a folder: "eyes.png: 1 frame, 240x240, 5 KB".
std::string written_picture_text(const std::filesystem::path& output, const std::string& contents, Size size,
                                 std::uintmax_t bytes);

}
