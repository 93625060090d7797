#pragma once

#include "host/preview/files/file_watch.hpp"
#include "host/preview/viewer/opened_scene.hpp"
#include "host/preview/viewer/scene_layers.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace kfast {

/// A scene with all that is shown of it. Nothing, if it could not be read.
struct ReadScene {
    std::unique_ptr<OpenedScene> scene;
    std::unique_ptr<SceneLayers> layers; ///< look into `scene`

    explicit operator bool() const { return layers != nullptr; }
};

/// Reads the scenes of a preview, and tells when one is to be read again because a file has changed on disk.
class SceneReader {
public:
    using Seconds = FileWatch::Seconds;

    /// `first` has been opened already; with mistakes it counts as a file that open() failed for.
    SceneReader(Opener opener, const OpenedScene& first);

    /// Another file, or the same. If that fails, changed() names it once it, or what belongs to it, has
    /// changed.
    ReadScene open(const std::filesystem::path& file);
    /// The file that was read last. If that fails, changed() names it once more after another change.
    ReadScene read_again();
    /// A file that could not be opened, or the one that was read last, if now is the time to read it.
    std::optional<std::filesystem::path> changed(Seconds now);

    const std::filesystem::path& file() const { return file_; }
    /// The one of the last attempt, which errors() are of.
    const std::filesystem::path& tried() const { return tried_; }
    /// Of the last attempt, line by line; empty when it went well.
    const std::vector<std::string>& errors() const { return errors_; }

private:
    struct Failed {
        std::filesystem::path file;
        FileWatch watch;
    };

    /// `tried` becomes what was looked at, if that fails and is known.
    ReadScene read(const std::filesystem::path& file, FileWatch& tried);

    Opener opener_;
    std::filesystem::path file_;
    std::filesystem::path tried_;
    FileWatch watch_; ///< of all files that what was read last depends on
    std::optional<Failed> failed_;
    std::vector<std::string> errors_;
};

}
