#include "host/preview/terminal/keyboard.hpp"

#include "host/preview/terminal/typed_keys.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <poll.h>
#include <string>
#include <string_view>
#include <thread>
#include <unistd.h>

namespace kfast {
namespace {

constexpr int within_a_key = 25; // milliseconds: the bytes of one key come together, even over a network

/// Whether there is something to read, within so many milliseconds.
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

}
