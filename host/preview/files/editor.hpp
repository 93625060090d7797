#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <sys/types.h>
#include <vector>

namespace kfast {

/// A line of a text file, counted from 1.
struct TextLine {
    std::filesystem::path file;
    std::size_t line = 1;

    friend bool operator==(const TextLine&, const TextLine&) = default;
};

/// The editor that the user has set: KFAST_EDITOR, then VISUAL, then EDITOR. Throws Failure if none is set.
std::string chosen_editor();

/// For a shell: the editor with the file at that line, as far as its option for that is known. `editor`
/// may have options, and {file} and {line} in it are replaced.
std::string editor_command(std::string_view editor, const TextLine& at);

/// Whether it is known to use the whole terminal.
bool takes_terminal(std::string_view editor);

/// The line of the first mistake in that file that has been reported in `messages`, as in
/// "lamp.kfast:3:5: error: …".
std::optional<std::size_t> line_of_mistake(std::span<const std::string> messages,
                                           const std::filesystem::path& file);

/// Lets a person change a file.
class Editor {
public:
    virtual ~Editor() = default;

    /// Throws Failure, whose text says what would help.
    virtual void open(const TextLine& at) = 0;
    /// Returns once why an editor that was opened has failed; empty if there is nothing to report.
    virtual std::string take_failure() { return {}; }
};

/// Starts the editor that the user has set, while the preview in its window goes on. One that takes the
/// terminal gets the one that the preview was started in; the end of this waits for it.
class EditorBeside final : public Editor {
public:
    EditorBeside() = default;
    ~EditorBeside() override;
    EditorBeside(const EditorBeside&) = delete;
    EditorBeside& operator=(const EditorBeside&) = delete;

    void open(const TextLine& at) override;
    std::string take_failure() override;

private:
    struct Running {
        pid_t process;
        std::string editor;
        bool has_terminal;
    };
    std::vector<Running> running_;
};

/// Runs the editor that the user has set in the terminal, until it ends. Throws Failure.
void edit_in_terminal(const TextLine& at);

}
