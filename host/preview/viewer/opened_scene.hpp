#pragma once

#include "core/math/affine.hpp"
#include "host/compile/scene_file.hpp"
#include "host/fit/target.hpp"
#include "host/picture/frame_source.hpp"
#include "host/preview/board/board_changes.hpp"
#include "host/preview/board/fit_check.hpp"
#include "host/preview/files/file_watch.hpp"
#include "host/preview/files/panel_pictures.hpp"
#include "host/preview/overlay/onion_skin.hpp"
#include "host/preview/overlay/overlay_source.hpp"
#include "host/preview/playback/playback_setup.hpp"
#include "host/preview/playback/preview_playback.hpp"
#include "host/preview/playback/time_table.hpp"
#include "host/program/failure.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace kfast {

/// A scene that a preview has open, on the display that was chosen.
struct OpenedScene {
    std::filesystem::path file;
    SceneFile scene;
    std::unique_ptr<FrameSource> source; ///< refers to `scene`
    PlaybackSetup playback_setup;        ///< refers to `scene`
    Size panel;
    Fit fit = Fit::contain;
    bool is_round = false;       ///< the corners of the panel are not visible
    bool is_beam = false;        ///< the screen of a vector display
    std::string panel_name = {}; ///< of its controller; empty if none was named
    /// The board of the fit report and the changed areas, with the display that is shown; none:
    /// previewed_board() of the panel.
    std::optional<fit::Target> board = {};
    FileWatch read = {}; ///< of all files that what is shown depends on, as they were before they were read
    std::shared_ptr<const PanelPictures> beside = {}; ///< shown at the right of this one; or none
    /// Sets the drawings that were chosen for its inputs, in receivers besides `source`; may be
    /// empty.
    std::function<void(InputReceiver&)> apply_drawings = {};
    std::string warnings = {}; ///< what was found, line by line, if it was not printed
    /// The errors of a text that cannot be shown: this is an empty scene in its place.
    std::string mistakes = {};
};

/// The failure to open a scene, with all that was found in its text.
class OpeningFailed : public Failure {
public:
    OpeningFailed(const std::string& text, FileWatch read) : Failure{text}, read_{std::move(read)} {}

    /// All files that were read, in their state before: a change in one of them may fix it.
    const FileWatch& read() const { return read_; }

private:
    FileWatch read_;
};

/// Opens a file with the options of the command. Throws OpeningFailed.
using Opener = std::function<std::unique_ptr<OpenedScene>(const std::filesystem::path& file)>;

/// What is shown of a scene besides its pictures.
class SceneLayers {
public:
    /// `scene` must outlive it.
    explicit SceneLayers(OpenedScene& scene);

    const TimeTable& table() const { return table_; }
    /// Includes the quantities of the unfolded items. Valid until the next call.
    const TimeTable& table(const std::set<std::size_t>& unfolded);
    /// At the time of `playback`, with its inputs; `scale` as in OverlaySource. Valid until the next call.
    const Overlay& overlay(const PreviewPlayback& playback, const ViewOptions& view, double scale);
    std::optional<std::size_t> item_at(const PreviewPlayback& playback, PanelSpot spot);
    ItemFacts facts(const PreviewPlayback& playback, std::size_t item);
    /// The picture with the key frames before and after it within what is played: those of the selected item
    /// and of its contents, or of all. Valid until the next call.
    const Picture& onion_skin(const PreviewPlayback& playback, std::optional<std::size_t> selected);
    /// The seconds that the board takes for the picture at a time after the one that was asked for before,
    /// with the inputs of `playback`. Not on a beam.
    double board_seconds(const PreviewPlayback& playback, Time moment);
    /// The name of the board.
    std::string board_name() const { return board().name; }
    /// None while it is being made, which the first call begins.
    std::optional<std::span<const FitLine>> fit_report();

private:
    Viewport viewport() const;
    fit::Target board() const;
    std::vector<Time> skin_keys(PlayRange played, std::optional<std::size_t> selected) const;

    OpenedScene& scene_;
    TimeTable table_;
    TimeTable unfolded_table_;
    std::set<std::size_t> unfolded_;
    std::unique_ptr<BoardPace> pace_;
    OverlaySource overlays_;
    OnionSkin skin_;
    std::vector<InputKnob> skin_inputs_; ///< with which the skin's pictures were made
    bool skin_reveals_travel_ = false;   ///< with which the skin's pictures were made
    std::unique_ptr<FitCheck> fit_;
};

/// A scene with all that is shown of it. Empty, if it could not be read.
struct ReadScene {
    std::unique_ptr<OpenedScene> scene;
    std::unique_ptr<SceneLayers> layers; ///< refer to `scene`

    explicit operator bool() const { return layers != nullptr; }
};

/// Reads the scenes of a preview, and reports when one must be read again because a file has changed on disk.
class SceneReader {
public:
    using Seconds = FileWatch::Seconds;

    /// `first` has been opened already; with mistakes it counts as a file that open() failed for.
    SceneReader(Opener opener, const OpenedScene& first);

    /// Opens another file, or the same. If that fails, changed() names it once it, or what belongs to it, has
    /// changed.
    ReadScene open(const std::filesystem::path& file);
    /// Reads the last file again. If that fails, changed() names it once more after another change.
    ReadScene read_again();
    /// The file that could not be opened, or the one that was read last, if it is time to read it.
    std::optional<std::filesystem::path> changed(Seconds now);

    const std::filesystem::path& file() const { return file_; }
    /// The file of the last attempt, which errors() are about.
    const std::filesystem::path& tried() const { return tried_; }
    /// The errors of the last attempt, line by line; empty when it went well.
    const std::vector<std::string>& errors() const { return errors_; }

private:
    struct Failed {
        std::filesystem::path file;
        FileWatch watch;
    };

    /// `tried` becomes the files that were read, if that fails and they are known.
    ReadScene read(const std::filesystem::path& file, FileWatch& tried);

    Opener opener_;
    std::filesystem::path file_;
    std::filesystem::path tried_;
    FileWatch watch_; ///< of all files that what was read last depends on
    std::optional<Failed> failed_;
    std::vector<std::string> errors_;
};

}
