#include "host/preview/terminal/borrowed_terminal.hpp"

#include "host/preview/terminal/half_blocks.hpp"
#include "host/program/failure.hpp"

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
#include <thread>
#include <unistd.h>

namespace kfast {

namespace {

/// The bytes of keys that are no letters, the longer first.
struct Sent {
    std::string_view bytes;
    std::string_view name;
};

constexpr std::array sent{
    Sent{"\x1b[A", "up"}, Sent{"\x1b[B", "down"},      Sent{"\x1b[C", "right"}, Sent{"\x1b[D", "left"},
    Sent{"\x1bOA", "up"}, Sent{"\x1bOB", "down"},      Sent{"\x1bOC", "right"}, Sent{"\x1bOD", "left"},
    Sent{" ", "space"},   Sent{"\x1b[Z", "shift-tab"}, Sent{"\t", "tab"},       Sent{"\r", "enter"},
    Sent{"\n", "enter"},
};

/// Whether it is a key by itself; otherwise it begins another one, or means that Alt is held with it.
bool is_escape(std::string_view bytes)
{
    const std::string_view behind = bytes.substr(1);
    return bytes.front() == '\x1b' &&
           (behind.empty() ||
            (behind.starts_with('\x1b') && !behind.starts_with("\x1b[") && !behind.starts_with("\x1bO")));
}

Sent first_key(std::string_view bytes)
{
    for (const Sent& key : sent)
        if (bytes.starts_with(key.bytes))
            return key;
    const std::string_view letter = bytes.substr(0, 1);
    return {letter, is_escape(bytes) ? "escape" : letter};
}

}

std::vector<PreviewKey> typed_keys(std::string_view bytes)
{
    std::vector<PreviewKey> keys;
    while (!bytes.empty()) {
        const Sent first = first_key(bytes);
        if (const auto key = preview_key(first.name))
            keys.push_back(*key);
        bytes.remove_prefix(first.bytes.size());
    }
    return keys;
}

namespace {

constexpr int within_a_key = 25; // milliseconds: the bytes of one key come together, even over a network

/// Whether there is something to read, within `milliseconds`.
bool waits_for_bytes(int milliseconds)
{
    pollfd input{STDIN_FILENO, POLLIN, 0};
    return ::poll(&input, 1, std::max(milliseconds, 0)) > 0;
}

std::string read_bytes()
{
    std::array<char, 64> bytes{};
    const ssize_t count = ::read(STDIN_FILENO, bytes.data(), bytes.size());
    return {bytes.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0))};
}

/// Whether the last key may have more bytes than were read.
bool may_go_on(std::string_view bytes)
{
    return bytes.ends_with("\x1b") || bytes.ends_with("\x1b[") || bytes.ends_with("\x1bO");
}

}

Keyboard::Keyboard()
    : works_{::tcgetpgrp(STDIN_FILENO) == ::getpgrp() && ::tcgetattr(STDIN_FILENO, &before_) == 0}
{
    take();
}

Keyboard::~Keyboard() { give_back(); }

void Keyboard::take()
{
    if (!works_)
        return;
    termios by_keys = before_;
    by_keys.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
    by_keys.c_cc[VMIN] = 0;
    by_keys.c_cc[VTIME] = 0;
    ::tcsetattr(STDIN_FILENO, TCSANOW, &by_keys);
}

void Keyboard::give_back()
{
    if (works_)
        ::tcsetattr(STDIN_FILENO, TCSANOW, &before_);
}

std::vector<PreviewKey> Keyboard::pressed(PreviewPlayback::Seconds patience)
{
    if (!works_) {
        std::this_thread::sleep_for(patience);
        return {};
    }
    if (!waits_for_bytes(static_cast<int>(std::ceil(patience.count() * 1000))))
        return {};
    std::string bytes = read_bytes();
    if (bytes.empty()) // the terminal is gone: poll() would not wait any more
        return {PreviewKey::quit};
    while (may_go_on(bytes) && waits_for_bytes(within_a_key)) {
        const std::string more = read_bytes();
        if (more.empty())
            break;
        bytes += more;
    }
    return typed_keys(bytes);
}

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
    for (const int number : ending_signals) // one that comes while the program is stopped ends it, as usual
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
