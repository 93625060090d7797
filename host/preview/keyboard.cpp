#include "host/preview/keyboard.hpp"

#include "host/preview/typed_keys.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <poll.h>
#include <thread>
#include <unistd.h>

namespace kfast {

Keyboard::Keyboard()
    : works_{::tcgetpgrp(STDIN_FILENO) == ::getpgrp() && ::tcgetattr(STDIN_FILENO, &before_) == 0}
{
    if (!works_)
        return;
    termios by_keys = before_;
    by_keys.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
    by_keys.c_cc[VMIN] = 0;
    by_keys.c_cc[VTIME] = 0;
    ::tcsetattr(STDIN_FILENO, TCSANOW, &by_keys);
}

Keyboard::~Keyboard()
{
    if (works_)
        ::tcsetattr(STDIN_FILENO, TCSANOW, &before_);
}

std::vector<PreviewKey> Keyboard::pressed(Playback::Seconds patience)
{
    if (!works_) {
        std::this_thread::sleep_for(patience);
        return {};
    }
    std::array<char, 64> bytes{};
    pollfd input{STDIN_FILENO, POLLIN, 0};
    const int milliseconds = static_cast<int>(std::ceil(patience.count() * 1000));
    if (::poll(&input, 1, std::max(milliseconds, 0)) <= 0)
        return {};
    const ssize_t count = ::read(STDIN_FILENO, bytes.data(), bytes.size());
    if (count <= 0) // the terminal is gone: poll() would not wait any more
        return {PreviewKey::quit};
    return typed_keys({bytes.data(), static_cast<std::size_t>(count)});
}

}
