#pragma once

#include <array>
#include <cstddef>
#include <mutex>
#include <ostream>
#include <streambuf>
#include <string_view>

namespace kfast {

/// Passes text on to another buffer with every code point as its glyph (glyph()), so that a terminal obeys
/// nothing in it; line ends and tabs stay. A code point may come in parts. Needs no memory of its own, so
/// that it works where there is none left, and may be written to by several threads.
class VisibleBuffer final : public std::streambuf {
public:
    /// `sink` must outlive it.
    explicit VisibleBuffer(std::streambuf& sink) : sink_{sink} {}
    /// Passes on what has come of a code point that was not completed.
    ~VisibleBuffer() override;

    /// For escape sequences of our own.
    void write_as_is(std::string_view text);

protected:
    int_type overflow(int_type letter) override;
    std::streamsize xsputn(const char* text, std::streamsize size) override;
    int sync() override;

private:
    bool pass(std::string_view text);
    bool pass_byte(char byte);
    bool pass_begun();
    bool send(std::string_view text);

    std::streambuf& sink_;
    std::mutex mutex_;
    std::array<char, 4> begun_{}; ///< a code point of several bytes
    std::size_t begun_size_ = 0;  ///< how many of them have come
};

/// While it lives, std::cout and std::cerr show what is written to them. All that a program prints is made of
/// names, texts and messages from elsewhere, so this is done once instead of at each of them.
class VisibleOutput {
public:
    VisibleOutput();
    ~VisibleOutput();
    VisibleOutput(const VisibleOutput&) = delete;
    VisibleOutput& operator=(const VisibleOutput&) = delete;

private:
    VisibleBuffer out_;
    VisibleBuffer error_;
    std::streambuf* previous_out_;
    std::streambuf* previous_error_;
};

/// Writes `text`, which must be all our own, so that a terminal obeys it: for colours and for going back to
/// the beginning of a line.
void write_as_is(std::ostream& out, std::string_view text);

}
