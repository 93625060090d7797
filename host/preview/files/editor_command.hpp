#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace kfast {

/// A line of a text file, counted from 1.
struct TextLine {
    std::filesystem::path file;
    std::size_t line = 1;

    friend bool operator==(const TextLine&, const TextLine&) = default;
};

/// The editor that the user has set: KFAST_EDITOR, else VISUAL, else EDITOR. Throws Failure if none is set.
std::string chosen_editor();

/// For a shell: the editor with the file at that line, as far as it is known how that is said to it. `editor`
/// may have options, and {file} and {line} in it stand for these.
std::string editor_command(std::string_view editor, const TextLine& at);

/// Whether it is known to be one that takes the whole terminal.
bool takes_terminal(std::string_view editor);

/// The line of the first mistake in that file that a reading has reported in `messages`, as in
/// "lamp.kfast:3:5: error: …".
std::optional<std::size_t> line_of_mistake(std::span<const std::string> messages,
                                           const std::filesystem::path& file);

}
