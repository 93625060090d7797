#pragma once

#include "host/picture/picture.hpp"
#include "host/preview/board/fit_check.hpp"
#include "host/preview/controls/preview_key.hpp"
#include "host/preview/controls/view_options.hpp"
#include "host/preview/files/editor.hpp"
#include "host/preview/files/file_dialogue.hpp"
#include "host/preview/files/written_files.hpp"
#include "host/preview/overlay/overlay.hpp"
#include "host/preview/playback/preview_playback.hpp"
#include "host/preview/playback/time_table.hpp"
#include "host/preview/viewer/opened_scene.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace kfast {

/// A preview apart from how it is shown: the scene that is open, its playback, what is shown of it, and
/// what went wrong. A window, a terminal and a script of keys drive it alike; the caller supplies the clock,
/// any steady time, and calls attend() again and again.
class Viewer {
public:
    using Seconds = PreviewPlayback::Seconds;

    /// Plays `scene`; `opener` opens later ones. With `loops`, quits after that many plays, as
    /// PreviewPlayback.
    Viewer(Opener opener, std::unique_ptr<OpenedScene> scene, Seconds now,
           std::optional<int> loops = std::nullopt);
    ~Viewer();

    /// Without a chooser, PreviewKey::read_file reads the same file afresh.
    void let_choose(std::unique_ptr<FileChooser> chooser) { chooser_ = std::move(chooser); }

    /// Without an editor, PreviewKey::edit only reports that.
    void let_edit(std::unique_ptr<Editor> editor) { editor_ = std::move(editor); }

    /// While it works, any key only stops the work.
    void press(PreviewKey key, Seconds now);
    /// The receiver of the events that are passed, in order.
    void set_on_event(PreviewPlayback::OnEvent on_event);
    /// Opens another file, or the same afresh: from its beginning, with nothing selected. If that fails, what
    /// was open continues, errors() says why, and it is tried again when that file changes.
    void open(const std::filesystem::path& file, Seconds now);
    /// Does what is due: continues playing and working, takes the file that was chosen, and reads the scene
    /// again if a file has changed on disk that it depends on, to continue from the same state. Returns true
    /// if something besides the time may have changed of what is to be shown.
    bool attend(Seconds now);
    /// Pauses at this time: the time line was touched.
    void scrub(Time moment);
    void select(std::optional<std::size_t> item);
    /// Folds or unfolds the quantities of an item on the time line.
    void fold(std::size_t item);
    /// Opens the text of the scene in the editor: where the first mistake is, otherwise where the selected
    /// item begins, otherwise at its first line.
    void edit();
    /// Sets ViewOptions::board_speed; the notice says so if that is not possible.
    void play_as_board(bool as_board, Seconds now);
    /// Sets ViewOptions::zoom. Closes the help and clears the notice, as keys do.
    void set_zoom(int zoom);
    /// Ends it in any state: the window was closed.
    void close();

    /// Whether it generates frames or writes a file: then attend() must be called without waiting.
    bool is_working() const { return frames_in_work() != nullptr || gif_ != nullptr; }
    /// How much of that is done, from 0 to 1; none if it does not work.
    std::optional<double> progress() const;
    bool wants_to_quit() const { return is_closed_ || playback_->wants_to_quit(); }

    const OpenedScene& scene() const { return *shown_.scene; }
    const PreviewPlayback& playback() const { return *playback_; }
    const ViewOptions& view() const { return view_; }
    /// What the panel shows now. Valid until the next call of a member.
    const Frame& frame();
    /// The picture to show now, with the onion skin if that is wanted. Valid as frame() is.
    const Picture& picture();
    /// The overlay that view() asks for, where a pixel of the panel is `scale` pixels of a window wide. Valid
    /// as frame() is.
    const Overlay& overlay(double scale);
    const TimeTable& time_table() const { return shown_.layers->table(); }
    /// The same with rows for the quantities that are unfolded. Valid as frame() is.
    const TimeTable& unfolded_table() { return shown_.layers->table(view_.unfolded); }
    /// The facts of the selected item at this time; none if none is selected.
    std::optional<ItemFacts> selected_facts();
    /// The line where it begins in the text, if that is known.
    std::optional<TextLine> selected_line() const;
    /// None while it is being made, or if view() does not ask for it.
    std::optional<std::span<const FitLine>> fit_report();
    /// The topmost item at a point of the panel.
    std::optional<std::size_t> item_at(PanelSpot spot);

    /// The errors of the last attempt to read a file, line by line; empty when it went well.
    const std::vector<std::string>& errors() const { return reader_.errors(); }
    /// A message about what was done last: "eyes-0012.png is written".
    const std::string& notice() const { return notice_; }
    /// A new number each time that something is reported, also for the same text again.
    std::uint64_t notice_number() const { return notice_number_; }
    /// The playback's, then "  all frames" while space steps through them, "  selected lamp", and what
    /// view() shows, "  onion skin  zoom 2".
    std::string status() const;
    /// The name as on the time line; "" if nothing is selected.
    std::string_view selected_name() const;

private:
    const FrameCollection* frames_in_work() const;
    void notify(std::string notice);
    void put(ReadScene scene, std::unique_ptr<PreviewPlayback> playback, Seconds now);
    void reload(Seconds now);
    bool read_what_changed(Seconds now);
    bool take_chosen_file(Seconds now);
    void stop_work();
    void go_on_working();
    bool fits_in_memory(std::size_t frames);
    void generate_all_frames();
    void begin_gif();
    void write_screenshot();
    void ask_for_file(Seconds now);
    void act(PreviewKey key, Seconds now);
    TextLine line_to_edit() const;
    void fold_selected();
    void set_pace(Seconds now);

    SceneReader reader_;
    std::optional<int> loops_;
    PreviewPlayback::OnEvent on_event_;
    ReadScene shown_;
    std::unique_ptr<PreviewPlayback> playback_; ///< refers to `shown_`
    std::unique_ptr<FileChooser> chooser_;
    std::unique_ptr<Editor> editor_;
    ViewOptions view_;
    std::optional<FrameCollection> all_frames_; ///< space steps through them once they are complete
    std::unique_ptr<GifWriting> gif_;
    Picture picture_;
    std::string facts_; ///< of the picture that was shown last
    std::string notice_;
    std::uint64_t notice_number_ = 0;
    bool has_report_ = false; ///< whether one that is wanted is made, as attend() found last
    bool is_closed_ = false;
};

}
