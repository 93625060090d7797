#pragma once

#include "host/preview/controls/preview_key.hpp"
#include "host/preview/viewer/viewer.hpp"

#include <functional>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <string_view>

namespace kfast {

/// One step of an absent user: a key, or what a mouse would do.
struct ScriptStep {
    enum class Kind {
        key,
        frame,  ///< the time line is touched at frame `number`
        select, ///< the item that is called `text`; none if that is empty
        open,   ///< the file `text` is dropped
        wait,   ///< `number` seconds pass
    };
    Kind kind = Kind::key;
    PreviewKey key = PreviewKey::help;
    double number = 0;
    std::string text = {};
};

/// A key by its name (preview_key), or "frame=12.5", "select=lamp", "open=FILE", "wait=0.5".
std::optional<ScriptStep> script_step(std::string_view word);

/// Plays every frame of one pass once on a clock of its own, through the same state as a window, and writes
/// the events that it passes, "event 12.5 step" (at frame 12.5), then "60 frames, hash 1a2b3c4d" (CRC-32 over
/// the pixels of all of them).
void play_headless(FrameSource& source, const PlaybackSetup& playback_setup, std::ostream& out);

/// Called for a key instead of pressing it on the viewer.
using KeyPress = std::function<void(PreviewKey, Viewer::Seconds)>;

/// Takes the steps of `script` one after another, a frame of time apart and each to its end, and writes the
/// events passed, "error: " and "notice: " with the text of viewer.errors() and notice(), and what is shown
/// after each, then the summary of these pictures. Stops at a quit. The clock of `viewer` began at 0. Throws
/// Failure for an object that does not exist.
void play_script(Viewer& viewer, std::span<const ScriptStep> script, std::ostream& out,
                 const KeyPress& press = {});

/// A window of a preview as it looks after a script (play_script, which writes to `out`), drawn without a
/// display. It waits for what is being computed, such as the fit report.
Picture snapshot(Viewer& viewer, std::span<const ScriptStep> script, Size window, std::ostream& out);

}
