#include "host/commands/text/status_line.hpp"

#include <iostream>
#include <unistd.h>

namespace kfast {

StatusLine::StatusLine() : is_seen_{::isatty(STDERR_FILENO) == 1} {}

StatusLine::~StatusLine()
{
    if (width_ != 0)
        std::cerr << '\r' << std::string(width_, ' ') << '\r' << std::flush;
}

void StatusLine::show(const std::string& text)
{
    if (!is_seen_)
        return;
    const std::size_t left_over = width_ > text.size() ? width_ - text.size() : 0;
    std::cerr << '\r' << text << std::string(left_over, ' ') << std::flush;
    width_ = text.size();
}

}
