#pragma once

#include "core/math/point.hpp"

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <string>
#include <string_view>

namespace kfast {

enum class StandardOutput { is_meant, is_refused }; ///< by "-"

/// Adds -o, --output. An empty name, and "-" where it is refused, are a wrong use: both are mostly a slip in
/// a script, and a file called "-" is hard to get rid of.
CLI::Option* declare_output(CLI::App& app, std::string& output, const std::string& help,
                            StandardOutput by_dash = StandardOutput::is_refused);

/// `output`, unless it is the file that `input` names: then throws Failure, for what it holds would be lost:
/// "the scene itself".
std::filesystem::path output_path(const std::filesystem::path& output, const std::filesystem::path& input,
                                  std::string_view what = "scene itself");

/// Makes it, unless it is there. Throws Failure.
void make_output_folder(const std::filesystem::path& folder);

/// Adds --json, with which a command prints JSON to standard output in place of its text. As of the next one,
/// the value must outlive the parsing of `app`; the option is returned, so that others can exclude it.
CLI::Option* declare_json(CLI::App& app, bool& json);
/// Adds -q, --quiet, with which a command prints nothing but errors and warnings about a scene.
CLI::Option* declare_quiet(CLI::App& app, bool& quiet);

/// Where a command reports what it has written: standard output, or a stream that discards everything if it
/// is to be quiet. Lives as long as the program.
std::ostream& report_stream(bool quiet);

/// The size of a file in units of 1000 bytes, as lists of files have it: "310 bytes", "110 KB", "1.2 MB".
std::string file_size_text(std::uintmax_t bytes);

/// The size of a file that has been written; 0 of what is no file, such as a device.
std::uintmax_t written_bytes(const std::filesystem::path& file);

/// What is printed when pictures have been written to a file or a folder: "eyes.png: 1 frame, 240x240, 5 KB".
std::string written_picture_text(const std::filesystem::path& output, const std::string& contents, Size size,
                                 std::uintmax_t bytes);

}
