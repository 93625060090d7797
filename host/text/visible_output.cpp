#include "host/text/visible_output.hpp"

#include "core/bytes/code_point.hpp"
#include "host/text/characters.hpp"

#include <algorithm>
#include <iostream>
#include <utility>

namespace kfast {
namespace {

bool stays(char byte) { return (byte >= ' ' && byte <= '~') || byte == '\n' || byte == '\t'; }

/// By the first byte of a code point; 1 for a byte that begins none.
std::size_t length_by(char first)
{
    const auto byte = static_cast<unsigned char>(first);
    if (byte < 0xC0)
        return 1;
    if (byte < 0xE0)
        return 2;
    return byte < 0xF0 ? 3 : 4;
}

}

VisibleBuffer::~VisibleBuffer() { pass_begun(); }

void VisibleBuffer::write_as_is(std::string_view text)
{
    const std::scoped_lock lock{mutex_};
    pass_begun();
    send(text);
}

VisibleBuffer::int_type VisibleBuffer::overflow(int_type letter)
{
    if (traits_type::eq_int_type(letter, traits_type::eof()))
        return traits_type::not_eof(letter);
    const char byte = traits_type::to_char_type(letter);
    return xsputn(&byte, 1) == 1 ? letter : traits_type::eof();
}

std::streamsize VisibleBuffer::xsputn(const char* text, std::streamsize size)
{
    const std::scoped_lock lock{mutex_};
    return pass({text, static_cast<std::size_t>(size)}) ? size : 0;
}

int VisibleBuffer::sync()
{
    const std::scoped_lock lock{mutex_};
    return sink_.pubsync();
}

bool VisibleBuffer::pass(std::string_view text)
{
    bool is_sent = true;
    while (is_sent && !text.empty()) {
        const auto plain = static_cast<std::size_t>(std::ranges::find_if_not(text, stays) - text.begin());
        if (plain > 0)
            is_sent = pass_begun() && send(text.substr(0, plain));
        else
            is_sent = pass_byte(text.front());
        text.remove_prefix(std::max<std::size_t>(plain, 1));
    }
    return is_sent;
}

/// One that does not stay as it is.
bool VisibleBuffer::pass_byte(char byte)
{
    if (!continues_sequence(byte) && !pass_begun())
        return false;
    begun_[begun_size_++] = byte;
    return begun_size_ < length_by(begun_.front()) || pass_begun();
}

bool VisibleBuffer::pass_begun()
{
    const std::string_view text{begun_.data(), std::exchange(begun_size_, 0)};
    bool is_sent = true;
    for (std::size_t at = 0; is_sent && at < text.size(); at += code_point_at(text, at).length)
        is_sent = send(glyph(code_point_at(text, at)).text);
    return is_sent;
}

bool VisibleBuffer::send(std::string_view text)
{
    const auto size = static_cast<std::streamsize>(text.size());
    return sink_.sputn(text.data(), size) == size;
}

VisibleOutput::VisibleOutput()
    : out_{*std::cout.rdbuf()},
      error_{*std::cerr.rdbuf()},
      previous_out_{std::cout.rdbuf(&out_)},
      previous_error_{std::cerr.rdbuf(&error_)}
{
}

VisibleOutput::~VisibleOutput()
{
    std::cout.rdbuf(previous_out_);
    std::cerr.rdbuf(previous_error_);
}

void write_as_is(std::ostream& out, std::string_view text)
{
    if (auto* const buffer = dynamic_cast<VisibleBuffer*>(out.rdbuf()))
        buffer->write_as_is(text);
    else
        out << text;
}

}
