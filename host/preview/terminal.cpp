#include "host/preview/terminal.hpp"

#include "host/failure.hpp"
#include "host/preview/half_blocks.hpp"
#include "host/preview/steady_now.hpp"
#include "host/preview/typed_keys.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <poll.h>
#include <string>
#include <string_view>
#include <sys/ioctl.h>
#include <termios.h>
#include <thread>
#include <unistd.h>

namespace kfast {
namespace {

using Seconds = Playback::Seconds;

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

/// Lets single keys be read from standard input while it lives, where that is a terminal which is ours to
/// change: a job in the background would be stopped for it.
class Keyboard {
public:
    Keyboard() : works_{::tcgetpgrp(STDIN_FILENO) == ::getpgrp() && ::tcgetattr(STDIN_FILENO, &before_) == 0}
    {
        if (!works_)
            return;
        termios by_keys = before_;
        by_keys.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
        by_keys.c_cc[VMIN] = 0;
        by_keys.c_cc[VTIME] = 0;
        ::tcsetattr(STDIN_FILENO, TCSANOW, &by_keys);
    }
    ~Keyboard()
    {
        if (works_)
            ::tcsetattr(STDIN_FILENO, TCSANOW, &before_);
    }
    Keyboard(const Keyboard&) = delete;
    Keyboard& operator=(const Keyboard&) = delete;

    /// Those pressed since the last call; waits for some, but not longer than `patience`.
    std::vector<PreviewKey> pressed(Seconds patience) const
    {
        if (!works_) {
            std::this_thread::sleep_for(patience);
            return {};
        }
        std::array<char, 64> bytes{};
        pollfd input{STDIN_FILENO, POLLIN, 0};
        const bool any = ::poll(&input, 1, static_cast<int>(std::ceil(patience.count() * 1000))) > 0;
        const ssize_t count = any ? ::read(STDIN_FILENO, bytes.data(), bytes.size()) : 0;
        return typed_keys({bytes.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0))});
    }

private:
    termios before_{};
    bool works_;
};

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

TerminalColours terminal_colours()
{
    const char* says = std::getenv("COLORTERM");
    const std::string_view word = says == nullptr ? "" : says;
    return word == "truecolor" || word == "24bit" ? TerminalColours::true_colour
                                                  : TerminalColours::palette_256;
}

/// The picture in what the terminal has besides the status line and the line the cursor ends on.
std::string picture_text(const Frame& frame)
{
    const Size terminal = terminal_size();
    return half_blocks(widen(frame), {terminal.width, std::max(1, terminal.height - 2)}, terminal_colours());
}

/// Short waits, for a signal does not end one. While paused there is no next frame to wait for.
void take_keys_until(Seconds moment, const Keyboard& keyboard, Playback& playback)
{
    constexpr Seconds longest{0.05};
    bool any = false;
    for (Seconds now = steady_now(); !any && now < moment && signal_seen == 0; now = steady_now())
        for (const PreviewKey key : keyboard.pressed(std::min(moment - now, longest))) {
            playback.press(key, steady_now());
            any = true;
        }
}

std::string up(std::ptrdiff_t lines) { return "\x1b[" + std::to_string(lines) + 'A'; }

/// A status that wraps would break the way back up.
std::string status_line(const FrameSource& source, const Playback& playback)
{
    return status_of(source, playback).substr(0, static_cast<std::size_t>(terminal_size().width - 1)) +
           "\x1b[J\n";
}

void play(FrameSource& source, Playback& playback)
{
    constexpr Seconds pause{1};
    const Keyboard keyboard;
    std::string rewind;
    while (!playback.wants_to_quit() && signal_seen == 0) {
        playback.advance_to(steady_now());
        const std::string picture = picture_text(show(source, playback));
        write_all(rewind + picture + status_line(source, playback));
        rewind = up(std::ranges::count(picture, '\n') + 1);
        if (!playback.wants_to_quit())
            take_keys_until(playback.playing() ? playback.next_frame_at() : steady_now() + pause, keyboard,
                            playback);
    }
}

}

void play_in_terminal(FrameSource& source, const Programme& programme, int loops)
{
    if (::isatty(STDOUT_FILENO) == 0)
        return write_all(picture_text(source.show(Time{0})));
    const BorrowedTerminal terminal;
    Playback playback{programme, source.pace(), steady_now(), loops};
    play(source, playback);
}

}
