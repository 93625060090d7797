#pragma once

#include "host/preview/files/editor_command.hpp"

#include <string>
#include <sys/types.h>
#include <vector>

namespace kfast {

/// Lets a person change a file.
class Editor {
public:
    virtual ~Editor() = default;

    /// Throws Failure, whose text says what would help.
    virtual void open(const TextLine& at) = 0;
    /// Why an editor that was opened has not come to anything, once; empty if there is nothing to say.
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
