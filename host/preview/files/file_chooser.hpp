#pragma once

#include <filesystem>
#include <optional>

namespace kfast {

/// Asks a person for a file, while the preview goes on.
class FileChooser {
public:
    virtual ~FileChooser() = default;

    /// Asks, with the files of `folder` to begin with. Throws Failure if nobody can be asked, whose text says
    /// what would help.
    virtual void ask(const std::filesystem::path& folder) = 0;
    virtual bool is_asking() const = 0;
    /// The answer, once; nothing while there is none, or if none was chosen. Throws Failure, likewise, if
    /// asking went wrong.
    virtual std::optional<std::filesystem::path> take_answer() = 0;
};

}
