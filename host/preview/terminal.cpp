#include "host/preview/terminal.hpp"

#include "host/preview/borrowed_terminal.hpp"
#include "host/preview/half_blocks.hpp"
#include "host/preview/steady_now.hpp"
#include "host/preview/terminal_text.hpp"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <string_view>
#include <sys/ioctl.h>
#include <unistd.h>
#include <vector>

namespace kfast {

Size terminal_size()
{
    winsize size{};
    if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0 || size.ws_row == 0)
        return {80, 24};
    return {size.ws_col, size.ws_row};
}

TerminalColours colours_of_terminal()
{
    return terminal_colours(std::getenv("COLORTERM"), std::getenv("TERM"), std::getenv("NO_COLOR"));
}

namespace {

using Seconds = PreviewPlayback::Seconds;

/// Draws one picture above the other.
class TerminalScreen {
public:
    /// Below what others have written: the picture that was drawn last stays where it is.
    void begin_anew() { lines_ = 0; }

    bool fits() const { return size_ == terminal_size(); }

    void draw(Viewer& viewer, bool with_help)
    {
        const Size size = terminal_size();
        const TerminalContent content{viewer.picture(), viewer.status(), viewer.notice(), viewer.errors(),
                                      with_help ? &help_ : nullptr};
        const TerminalText drawn = terminal_text(content, size, colours_);
        write_to_terminal(way_back(size) + drawn.text);
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
    /// Lines may have been wrapped anew in a terminal of another size.
    std::string way_back(Size size) const
    {
        if (lines_ == 0)
            return {};
        return size_ == size ? "\x1b[" + std::to_string(lines_) + 'A' : "\x1b[2J\x1b[H";
    }

    TerminalColours colours_ = colours_of_terminal();
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

class TerminalPreview {
public:
    TerminalPreview(Viewer& viewer, Keyboard& keyboard) : viewer_{viewer}, keyboard_{keyboard} {}

    void play()
    {
        bool is_disturbed = true;
        while (!viewer_.wants_to_quit() && !terminal_.is_to_end()) {
            is_disturbed = stop_if_asked() || is_disturbed;
            const bool has_changed = viewer_.attend(now()) || is_disturbed || !screen_.fits();
            const bool is_last = viewer_.wants_to_quit();
            if (times_.is_due(viewer_, has_changed || is_last, now()))
                screen_.draw(viewer_, keyboard_.works() && viewer_.playback().help_open());
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

bool can_play_in_terminal()
{
    const char* const type = std::getenv("TERM");
    return ::isatty(STDOUT_FILENO) != 0 && std::string_view{type == nullptr ? "" : type} != "dumb";
}

void write_as_text(const Frame& frame)
{
    const Size size = terminal_size();
    write_to_terminal(
        half_blocks(widen(frame), {size.width, std::max(1, size.height - 2)}, colours_of_terminal()));
}

}
