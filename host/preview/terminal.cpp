#include "host/preview/terminal.hpp"

#include "host/failure.hpp"
#include "host/preview/half_blocks.hpp"
#include "host/preview/steady_now.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>
#include <sys/ioctl.h>
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

/// Short sleeps, for a signal does not end one.
void sleep_until(Seconds moment)
{
    constexpr Seconds longest{0.05};
    for (Seconds now = steady_now(); now < moment && signal_seen == 0; now = steady_now())
        std::this_thread::sleep_for(std::min(moment - now, longest));
}

std::string up(std::ptrdiff_t lines) { return "\x1b[" + std::to_string(lines) + 'A'; }

/// A status that wraps would break the way back up.
std::string status_line(const Playback& playback)
{
    return playback.status().substr(0, static_cast<std::size_t>(terminal_size().width - 1)) + "\x1b[J\n";
}

void play(FrameSource& source, Playback& playback)
{
    std::string rewind;
    while (!playback.wants_to_quit() && signal_seen == 0) {
        playback.advance_to(steady_now());
        const std::string picture = picture_text(source.show(playback.time()));
        write_all(rewind + picture + status_line(playback));
        rewind = up(std::ranges::count(picture, '\n') + 1);
        if (!playback.wants_to_quit())
            sleep_until(playback.next_frame_at());
    }
}

}

void play_in_terminal(FrameSource& source, const Timeline& timeline, int loops)
{
    if (::isatty(STDOUT_FILENO) == 0)
        return write_all(picture_text(source.show(Time{0})));
    const BorrowedTerminal terminal;
    Playback playback{timeline, {}, steady_now(), loops};
    play(source, playback);
}

}
