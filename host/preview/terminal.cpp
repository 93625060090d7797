#include "host/preview/terminal.hpp"

#include "host/failure.hpp"
#include "host/preview/half_blocks.hpp"
#include "host/preview/steady_now.hpp"
#include "host/preview/terminal_text.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>
#include <sys/ioctl.h>
#include <unistd.h>

namespace kfast {
namespace {

using Seconds = PreviewPlayback::Seconds;

volatile std::sig_atomic_t signal_seen = 0;

extern "C" void remember_signal(int number) { signal_seen = number; }

void write_all(std::string_view text)
{
    while (!text.empty()) {
        const ssize_t count = ::write(STDOUT_FILENO, text.data(), text.size());
        if (count < 0 && errno != EINTR)
            throw Failure(std::string("cannot write to the terminal: ") + std::strerror(errno));
        text.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    }
}

/// Hides the cursor while it lives. A signal that would end the program is only remembered, and raised again
/// once the terminal is as it was.
class BorrowedTerminal {
public:
    BorrowedTerminal()
    {
        for (const int number : signals)
            std::signal(number, remember_signal);
        write_all("\x1b[?25l");
    }
    ~BorrowedTerminal()
    {
        constexpr std::string_view restore = "\x1b[0m\x1b[?25h";
        [[maybe_unused]] const ssize_t count = ::write(STDOUT_FILENO, restore.data(), restore.size());
        for (const int number : signals)
            std::signal(number, SIG_DFL);
        if (signal_seen != 0)
            std::raise(signal_seen);
    }
    BorrowedTerminal(const BorrowedTerminal&) = delete;
    BorrowedTerminal& operator=(const BorrowedTerminal&) = delete;

private:
    static constexpr std::array signals{SIGINT, SIGTERM, SIGHUP};
};

Size terminal_size()
{
    winsize size{};
    if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0 || size.ws_row == 0)
        return {80, 24};
    return {size.ws_col, size.ws_row};
}

TerminalColours these_colours()
{
    return terminal_colours(std::getenv("COLORTERM"), std::getenv("TERM"), std::getenv("NO_COLOR"));
}

/// Draws one picture above the other.
class TerminalScreen {
public:
    bool fits() const { return size_ == terminal_size(); }

    void draw(Viewer& viewer, bool with_help)
    {
        const Size size = terminal_size();
        const TerminalContent content{viewer.picture(), viewer.status(), viewer.notice(), viewer.errors(),
                                      with_help ? &help_ : nullptr};
        const TerminalText drawn = terminal_text(content, size, colours_);
        write_all(way_back(size) + drawn.text);
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

    TerminalColours colours_ = these_colours();
    OpenHelp help_{preview_key_help(PreviewFront::terminal)};
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

bool press_keys(TerminalScreen& screen, Viewer& viewer, Keyboard& keyboard)
{
    const std::vector<PreviewKey> keys = keyboard.pressed(patience(viewer, steady_now()));
    for (const PreviewKey key : keys)
        screen.press(key, viewer, steady_now());
    return !keys.empty();
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

void play(Viewer& viewer, Keyboard& keyboard)
{
    TerminalScreen screen;
    DrawTimes times;
    bool is_disturbed = true;
    while (!viewer.wants_to_quit() && signal_seen == 0) {
        const bool has_changed = viewer.attend(steady_now()) || is_disturbed || !screen.fits();
        const bool is_last = viewer.wants_to_quit();
        if (times.is_due(viewer, has_changed || is_last, steady_now()))
            screen.draw(viewer, keyboard.works() && viewer.playback().help_open());
        is_disturbed = !is_last && press_keys(screen, viewer, keyboard);
    }
}

}

void play_in_terminal(Viewer& viewer, Keyboard& keyboard)
{
    const BorrowedTerminal terminal;
    play(viewer, keyboard);
}

bool can_play_in_terminal()
{
    const char* const type = std::getenv("TERM");
    return ::isatty(STDOUT_FILENO) != 0 && std::string_view{type == nullptr ? "" : type} != "dumb";
}

void write_as_text(const Frame& frame)
{
    const Size size = terminal_size();
    write_all(half_blocks(widen(frame), {size.width, std::max(1, size.height - 2)}, these_colours()));
}

}
