#include "host/preview/terminal.hpp"

#include "host/preview/playback/preview_playback.hpp"
#include "host/preview/terminal/borrowed_terminal.hpp"
#include "host/preview/terminal/half_blocks.hpp"
#include "host/preview/terminal/terminal_text.hpp"
#include "host/preview/viewer/beside.hpp"
#include "host/program/failure.hpp"

#include <algorithm>
#include <exception>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace kfast {
namespace {

using Seconds = PreviewPlayback::Seconds;

/// Draws one picture above the other.
class TerminalScreen {
public:
    /// Draws the next one below what others have written: the last picture stays where it is.
    void begin_anew() { lines_ = 0; }

    bool fits() const { return size_ == terminal_size(); }

    /// Where no keys can be typed there is no help.
    void draw(Viewer& viewer, bool has_keys)
    {
        const Size size = terminal_size();
        const auto other = beside(viewer);
        const bool is_help_open = has_keys && viewer.playback().help_open();
        const TerminalContent content{viewer.picture(),
                                      viewer.status(),
                                      viewer.notice(),
                                      viewer.errors(),
                                      is_help_open ? &help_ : nullptr,
                                      other ? &other->picture : nullptr,
                                      other ? other->caption : "",
                                      has_keys && !is_help_open ? help_hint : ""};
        const TerminalText drawn = terminal_text(content, size, colours_);
        write_to_terminal(way_back(lines_, size_, size) + drawn.text);
        size_ = size;
        lines_ = drawn.lines;
    }

    /// A key that does nothing in a terminal still closes the help.
    void press(PreviewKey key, Viewer& viewer, Seconds now)
    {
        const bool is_help_open = viewer.playback().help_open();
        if (help_.turns(key, is_help_open && !viewer.is_working()))
            return;
        if (viewer.is_working() || works_in(PreviewFront::terminal, key))
            viewer.press(key, now);
        else if (is_help_open)
            viewer.press(PreviewKey::leave, now);
    }

private:
    TerminalColours colours_ = terminal_colours();
    OpenHelp help_{preview_help(PreviewFront::terminal)};
    Size size_{}; ///< of the terminal when it was drawn last
    int lines_ = 0;
};

/// Short waits, for a signal does not end one.
Seconds patience(const Viewer& viewer, Seconds now)
{
    constexpr Seconds longest{0.05};
    if (viewer.is_working())
        return Seconds{0};
    const bool plays = viewer.playback().playing();
    return plays ? std::clamp(viewer.playback().next_frame_at() - now, Seconds{0}, longest) : longest;
}

/// Draws what changes, and what plays at each frame.
class DrawTimes {
public:
    bool is_due(const Viewer& viewer, bool has_changed, Seconds now)
    {
        constexpr Seconds between_reports{0.1};
        const bool plays = viewer.playback().playing() || viewer.playback().time() != shown_;
        const bool is_due =
            viewer.is_working() ? now - drawn_ >= between_reports : has_changed || (plays && now >= next_);
        if (is_due) {
            drawn_ = now;
            shown_ = viewer.playback().time();
            next_ = viewer.playback().next_frame_at();
        }
        return is_due;
    }

private:
    Time shown_{-1};
    Seconds drawn_{0};
    Seconds next_{0};
};

/// Gives the terminal to the editor, and takes it back.
class EditorInstead final : public Editor {
public:
    using Run = std::function<void(const std::function<void()>&)>;

    explicit EditorInstead(Run run) : run_{std::move(run)} {}

    void open(const TextLine& at) override
    {
        std::string failure;
        run_([&] {
            try {
                edit_in_terminal(at);
            } catch (const std::exception& thrown) { // once the terminal is ours again
                failure = thrown.what();
            }
        });
        if (!failure.empty())
            throw Failure(failure);
    }

private:
    Run run_;
};

class TerminalPreview {
public:
    TerminalPreview(Viewer& viewer, Keyboard& keyboard) : viewer_{viewer}, keyboard_{keyboard}
    {
        viewer_.let_edit(std::make_unique<EditorInstead>([this](const auto& use) { run_in_terminal(use); }));
    }
    ~TerminalPreview() { viewer_.let_edit(nullptr); }
    TerminalPreview(const TerminalPreview&) = delete;

    void play()
    {
        bool is_disturbed = true;
        while (!viewer_.wants_to_quit() && !terminal_.is_to_end()) {
            is_disturbed = stop_if_asked() || is_disturbed;
            const bool has_changed = viewer_.attend(now()) || is_disturbed || !screen_.fits();
            const bool is_last = viewer_.wants_to_quit();
            if (times_.is_due(viewer_, has_changed || is_last, now()))
                screen_.draw(viewer_, keyboard_.works());
            is_disturbed = !is_last && press_keys();
        }
    }

private:
    Seconds now() const { return steady_now() - stood_still_; }

    bool stop_if_asked()
    {
        const Seconds before = now();
        if (!terminal_.stop_if_asked())
            return false;
        stood_still_ += now() - before;
        screen_.begin_anew();
        return true;
    }

    void run_in_terminal(const std::function<void()>& use)
    {
        const Seconds before = now();
        terminal_.suspend_for(use);
        stood_still_ += now() - before;
        screen_.begin_anew();
    }

    bool press_keys()
    {
        const std::vector<PreviewKey> keys = keyboard_.pressed(patience(viewer_, now()));
        for (const PreviewKey key : keys)
            screen_.press(key, viewer_, now());
        return !keys.empty();
    }

    Viewer& viewer_;
    Keyboard& keyboard_;
    BorrowedTerminal terminal_{keyboard_};
    TerminalScreen screen_;
    DrawTimes times_;
    Seconds stood_still_{0}; ///< in all, while the program was stopped
};

}

void play_in_terminal(Viewer& viewer, Keyboard& keyboard) { TerminalPreview{viewer, keyboard}.play(); }

void write_as_text(const Picture& picture) { write_to_terminal(terminal_picture(picture)); }

}
