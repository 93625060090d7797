#include "host/commands/live/line_source.hpp"

#include "host/program/failure.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <poll.h>
#include <unistd.h>

namespace kfast {
namespace {

constexpr std::size_t longest_line = 65536;

}

std::optional<std::string> LineSource::next(Milliseconds patience)
{
    if (auto line = buffered_line())
        return line;
    if (!has_ended_)
        read_more(patience);
    return buffered_line();
}

void LineSource::read_more(Milliseconds patience)
{
    pollfd input{descriptor_, POLLIN, 0};
    if (::poll(&input, 1, static_cast<int>(patience.count())) <= 0)
        return;
    std::array<char, 4096> bytes{};
    const ssize_t count = ::read(descriptor_, bytes.data(), bytes.size());
    if (count < 0 && errno != EINTR && errno != EAGAIN)
        throw Failure{std::string{"standard input cannot be read: "} + std::strerror(errno)};
    if (count == 0)
        has_ended_ = true;
    if (count > 0)
        buffer_.append(bytes.data(), static_cast<std::size_t>(count));
}

std::optional<std::string> LineSource::buffered_line()
{
    const std::size_t end = buffer_.find('\n');
    if (end == std::string::npos && buffer_.size() > longest_line)
        throw Failure{"line " + std::to_string(number_ + 1) + " is longer than any that means something"};
    if (end == std::string::npos && (!has_ended_ || buffer_.empty()))
        return std::nullopt;
    ++number_;
    std::string line = buffer_.substr(0, end);
    buffer_.erase(0, end == std::string::npos ? end : end + 1);
    return line;
}

}
