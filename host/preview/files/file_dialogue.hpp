#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <sys/types.h>

namespace kfast {

/// Asks a person for a file, while the preview goes on.
class FileChooser {
public:
    virtual ~FileChooser() = default;

    /// Asks, with the files of `folder` to begin with. Throws Failure if nobody can be asked, whose text says
    /// what would help.
    virtual void ask(const std::filesystem::path& folder) = 0;
    virtual bool is_asking() const = 0;
    /// The answer, once; none while there is none, or if none was chosen. Throws Failure, whose text says
    /// what would help, if asking went wrong.
    virtual std::optional<std::filesystem::path> take_answer() = 0;
};

/// Asks in the file dialogue of the desktop, zenity or kdialog, whichever is found in PATH first. It is a
/// program of its own, which ends with this.
class FileDialogue final : public FileChooser {
public:
    FileDialogue() = default;
    ~FileDialogue() override;
    FileDialogue(const FileDialogue&) = delete;
    FileDialogue& operator=(const FileDialogue&) = delete;

    void ask(const std::filesystem::path& folder) override;
    bool is_asking() const override { return process_ != 0; }
    std::optional<std::filesystem::path> take_answer() override;

private:
    void start(const std::filesystem::path& program, const std::filesystem::path& folder);
    bool has_ended();

    pid_t process_ = 0; ///< 0: none
    int answer_ = -1;   ///< what it writes, to be read without waiting
    std::string text_;  ///< as far as it was read
    std::string program_;
};

}
