#pragma once

#include "core/math/affine.hpp"
#include "host/compile/scene_file.hpp"
#include "host/fit/target.hpp"
#include "host/picture/frame_source.hpp"
#include "host/preview/files/file_watch.hpp"
#include "host/preview/files/panel_pictures.hpp"
#include "host/preview/playback/playback_setup.hpp"
#include "host/program/failure.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace kfast {

/// A scene that a preview has open, on the display that was chosen.
struct OpenedScene {
    std::filesystem::path file;
    SceneFile scene;
    std::unique_ptr<FrameSource> source; ///< looks into `scene`
    PlaybackSetup playback_setup;        ///< likewise
    Size panel;
    Fit fit = Fit::contain;
    bool is_round = false;       ///< the corners of the panel are not seen
    bool is_beam = false;        ///< the screen of a vector display
    std::string panel_name = {}; ///< of its controller; empty if none was named
    /// That the fit report and the changed areas are about, with the display that is shown; none:
    /// previewed_board() of the panel.
    std::optional<fit::Target> board = {};
    FileWatch read = {}; ///< of all files that what is shown depends on, as they were before they were read
    std::shared_ptr<const PanelPictures> beside = {}; ///< shown at the right of this one; or none
    /// Tells the drawings that were chosen for its inputs, to whoever shows it besides `source`; may be
    /// empty.
    std::function<void(InputReceiver&)> apply_drawings = {};
    std::string warnings = {}; ///< what was found, line by line, if it was not printed
    /// Likewise, of a text that cannot be shown: this is an empty scene in its place.
    std::string mistakes = {};
};

/// Why a scene was not opened, in a text that has all that was found.
class OpeningFailed : public Failure {
public:
    OpeningFailed(const std::string& text, FileWatch read) : Failure{text}, read_{std::move(read)} {}

    /// Of all files that were looked at, as they were before: a change in one of them may mend it.
    const FileWatch& read() const { return read_; }

private:
    FileWatch read_;
};

/// Opens a file as the options of the command say. Throws OpeningFailed.
using Opener = std::function<std::unique_ptr<OpenedScene>(const std::filesystem::path& file)>;

}
