#pragma once

#include "host/preview/playback/preview_playback.hpp"

#include <termios.h>
#include <vector>

namespace kfast {

/// Lets single keys be read from standard input while it lives, where that is a terminal which is ours to
/// change: a job in the background would be stopped for it.
class Keyboard {
public:
    Keyboard();
    ~Keyboard();
    Keyboard(const Keyboard&) = delete;
    Keyboard& operator=(const Keyboard&) = delete;

    /// For a time in which the program is stopped: the terminal is as it was.
    void give_back();
    void take();

    /// Whether keys can be pressed.
    bool works() const { return works_; }
    /// Those pressed since the last call; waits for some, but not longer than `patience`.
    std::vector<PreviewKey> pressed(PreviewPlayback::Seconds patience);

private:
    termios before_{};
    bool works_;
};

}
