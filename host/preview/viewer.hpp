#pragma once

#include "host/picture/picture.hpp"
#include "host/preview/opened_scene.hpp"
#include "host/preview/playback.hpp"
#include "host/preview/preview_key.hpp"
#include "host/preview/view_options.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace kfast {

/// A preview apart from how it is shown: the scene that is open, where it stands, what is shown of it, and
/// what went wrong. A window, a terminal and a script of keys drive it alike; the caller brings the clock,
/// any steady time.
class Viewer {
public:
    using Seconds = Playback::Seconds;

    /// Throws Failure if `file` cannot be opened.
    Viewer(Opener opener, const std::filesystem::path& file, Seconds now, std::optional<int> loops);

    void press(PreviewKey key, Seconds now);
    /// Another file, from its beginning and with nothing selected. If that fails, what was open goes on, and
    /// errors() says why.
    void open(const std::filesystem::path& file, Seconds now);
    /// Reads the file again if it has changed on disk, and goes on where it stood. Likewise.
    void reload_if_changed(Seconds now);
    void advance_to(Seconds now);
    /// Pauses at this moment: the time line was touched.
    void scrub(Time moment);
    void select(std::optional<std::size_t> item);

    const OpenedScene& scene() const { return *scene_; }
    const Playback& playback() const { return *playback_; }
    const ViewOptions& view() const { return view_; }
    /// The picture to show now, with the onion skin if that is wanted.
    const Picture& picture();
    /// Of the last attempt to read a file, line by line; empty when it went well.
    const std::vector<std::string>& errors() const { return errors_; }
    /// What was done last and is worth telling: "eyes-0012.png is written".
    const std::string& notice() const { return notice_; }
    std::string status() const;
    bool wants_to_quit() const { return playback_->wants_to_quit(); }

private:
    Opener opener_;
    std::unique_ptr<OpenedScene> scene_;
    std::unique_ptr<Playback> playback_;
    ViewOptions view_;
    Picture picture_;
    std::vector<std::string> errors_;
    std::string notice_;
};

}
