#pragma once

#include <array>
#include <cstddef>

namespace kfast::pico {

/// Lines to be sent, in a ring. A line counts from its '\n' on; one that does not fit is dropped whole.
class LogBuffer {
public:
    static constexpr std::size_t room = 2047;

    void write(char letter)
    {
        append(letter);
        if (letter == '\n')
            end_line();
    }

    /// Whether take() has a letter to give.
    bool has_more() const { return sent_ != line_end_; }

    char take()
    {
        const char letter = letters_[sent_];
        sent_ = after(sent_);
        return letter;
    }

private:
    static constexpr std::size_t after(std::size_t place) { return (place + 1) % (room + 1); }

    void append(char letter)
    {
        const std::size_t next = after(written_);
        is_short_ = is_short_ || next == sent_;
        if (is_short_)
            return;
        letters_[written_] = letter;
        written_ = next;
    }

    void end_line()
    {
        if (is_short_)
            written_ = line_end_;
        line_end_ = written_;
        is_short_ = false;
    }

    std::array<char, room + 1> letters_{};
    std::size_t sent_ = 0;     ///< the next to be sent
    std::size_t line_end_ = 0; ///< the end of the last line
    std::size_t written_ = 0;  ///< the end of what was written
    bool is_short_ = false;    ///< the line that is being written has lost letters
};

}
