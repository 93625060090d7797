#pragma once

#include "core/math/point.hpp"
#include "host/picture/picture.hpp"
#include "host/preview/controls/preview_key.hpp"
#include "host/preview/playback/preview_playback.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <termios.h>
#include <vector>

namespace kfast {

/// The keys that `bytes` of a terminal mean; what is none of a preview's keys is skipped. An escape at
/// the very end is the key of that name.
std::vector<PreviewKey> typed_keys(std::string_view bytes);

/// Lets single keys be read from standard input while it lives, where that is a terminal which is ours to
/// change: a job in the background would be stopped for it.
class Keyboard {
public:
    Keyboard();
    ~Keyboard();
    Keyboard(const Keyboard&) = delete;
    Keyboard& operator=(const Keyboard&) = delete;

    /// Called before the program is stopped: restores the terminal.
    void give_back();
    void take();

    /// Whether keys can be pressed.
    bool works() const { return works_; }
    /// The keys pressed since the last call; waits for some, but not longer than `patience`.
    std::vector<PreviewKey> pressed(PreviewPlayback::Seconds patience);

private:
    termios before_{};
    bool works_;
};

/// The terminal that standard output is, to draw pictures on: its cursor is hidden while this lives. Signals
/// that end or stop the program are only remembered, so that the terminal can be left as it was before they
/// do. One at a time. Throws Failure when the terminal cannot be written.
class BorrowedTerminal {
public:
    explicit BorrowedTerminal(Keyboard& keyboard);
    /// Gives the terminal and the keyboard back, and raises the signal that ends the program, if one came.
    ~BorrowedTerminal();
    BorrowedTerminal(const BorrowedTerminal&) = delete;
    BorrowedTerminal& operator=(const BorrowedTerminal&) = delete;

    /// Whether a signal came that ends the program.
    bool is_to_end() const;
    /// Stops the program if that was requested (Ctrl-Z), with the terminal given back, until its shell
    /// continues it. Returns true if it did: what is on the terminal then belongs to others.
    bool stop_if_asked();

    /// Gives it back while `use`, which throws nothing, runs another program in it.
    void suspend_for(const std::function<void()>& use);

private:
    void take();
    void give_back();

    Keyboard& keyboard_;
};

/// The size in characters of the terminal that standard output is; 80x24 where it is not known.
Size terminal_size();

/// The picture as text, as large as fits the terminal that standard output is with two lines below it.
std::string terminal_picture(const Picture& picture);

/// The bytes that go back over `lines` lines, to draw others in their place. Where the terminal had another
/// size when they were drawn, they may have been wrapped anew: then it clears all.
std::string way_back(std::ptrdiff_t lines, Size before, Size now);

/// Whether standard output is a terminal that pictures can be drawn on one above the other.
bool can_play_in_terminal();

/// Writes all of `text` to standard output. Throws Failure.
void write_to_terminal(std::string_view text);

}
