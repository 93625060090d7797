#include "host/preview/terminal/borrowed_terminal.hpp"

#include "host/preview/terminal/half_blocks.hpp"
#include "host/preview/terminal/terminal_colours.hpp"
#include "host/program/failure.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <string>
#include <sys/ioctl.h>
#include <unistd.h>

namespace kfast {
namespace {

constexpr std::array ending_signals{SIGINT, SIGTERM, SIGHUP, SIGQUIT};

volatile std::sig_atomic_t ending_signal = 0;
volatile std::sig_atomic_t is_to_stop = 0;

extern "C" void remember_end(int number) { ending_signal = number; }
extern "C" void remember_stop(int) { is_to_stop = 1; }

}

void write_to_terminal(std::string_view text)
{
    while (!text.empty()) {
        const ssize_t count = ::write(STDOUT_FILENO, text.data(), text.size());
        if (count < 0 && errno != EINTR)
            throw Failure(std::string("cannot write to the terminal: ") + std::strerror(errno));
        text.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    }
}

BorrowedTerminal::BorrowedTerminal(Keyboard& keyboard) : keyboard_{keyboard} { take(); }

BorrowedTerminal::~BorrowedTerminal()
{
    give_back();
    if (ending_signal != 0)
        std::raise(ending_signal);
}

void BorrowedTerminal::take()
{
    for (const int number : ending_signals)
        std::signal(number, remember_end);
    std::signal(SIGTSTP, remember_stop);
    keyboard_.take();
    write_to_terminal("\x1b[?25l");
}

void BorrowedTerminal::give_back()
{
    constexpr std::string_view as_usual = "\x1b[0m\x1b[?25h";
    [[maybe_unused]] const ssize_t count = ::write(STDOUT_FILENO, as_usual.data(), as_usual.size());
    keyboard_.give_back();
    for (const int number : ending_signals) // one that comes while the program is stopped ends it, as ever
        std::signal(number, SIG_DFL);
    std::signal(SIGTSTP, SIG_DFL);
}

void BorrowedTerminal::suspend_for(const std::function<void()>& use)
{
    give_back();
    use();
    take();
}

bool BorrowedTerminal::is_to_end() const { return ending_signal != 0; }

bool BorrowedTerminal::stop_if_asked()
{
    if (is_to_stop == 0)
        return false;
    give_back();
    std::raise(SIGTSTP);
    is_to_stop = 0;
    take();
    return true;
}

Size terminal_size()
{
    winsize size{};
    if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0 || size.ws_row == 0)
        return {80, 24};
    return {size.ws_col, size.ws_row};
}

std::string terminal_picture(const Picture& picture)
{
    const Size size = terminal_size();
    return half_blocks(picture, {size.width, std::max(1, size.height - 2)}, terminal_colours());
}

std::string way_back(std::ptrdiff_t lines, Size before, Size now)
{
    if (lines == 0)
        return {};
    return before == now ? "\x1b[" + std::to_string(lines) + 'A' : "\x1b[2J\x1b[H";
}

bool can_play_in_terminal()
{
    const char* const type = std::getenv("TERM");
    return ::isatty(STDOUT_FILENO) != 0 && std::string_view{type == nullptr ? "" : type} != "dumb";
}

}
