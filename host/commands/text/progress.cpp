#include "host/commands/text/progress.hpp"

#include "host/text/visible_output.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iomanip>
#include <iostream>
#include <string_view>
#include <unistd.h>

namespace kfast {

namespace {

/// In place of what stands on the last line, which is `width` wide. Needs no memory, for destructors.
void write_over(std::string_view text, std::size_t width)
{
    write_as_is(std::cerr, "\r");
    std::cerr << text;
    if (width > text.size())
        std::cerr << std::setw(static_cast<int>(width - text.size())) << "";
    std::cerr << std::flush;
}

}

StatusLine::StatusLine() : is_seen_{::isatty(STDERR_FILENO) == 1} {}

StatusLine::~StatusLine()
{
    if (width_ == 0)
        return;
    write_over("", width_);
    write_as_is(std::cerr, "\r");
}

void StatusLine::show(const std::string& text)
{
    if (!is_seen_)
        return;
    write_over(text, width_);
    width_ = text.size();
}

namespace {

constexpr std::size_t bar_width = 20;
/// Before, a rate would say little.
constexpr double min_rate_seconds = 0.1;

std::string bar(std::size_t done, std::size_t total)
{
    const std::size_t marks = bar_width * done / total;
    return '[' + std::string(marks, '#') + std::string(bar_width - marks, ' ') + ']';
}

/// "[#####               ]  25 %"
std::string share_text(std::size_t done, std::size_t total)
{
    std::array<char, 16> share{};
    std::snprintf(share.data(), share.size(), "  %3zu %%", 100 * done / total);
    return bar(done, total) + share.data();
}

std::string time_left(double seconds)
{
    const auto whole = static_cast<long>(std::ceil(std::min(seconds, 360'000.0)));
    if (whole < 60)
        return std::to_string(whole) + " s left";
    return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s left";
}

std::string rest_text(std::size_t done, std::size_t total, double rate)
{
    return done == total ? "" : "  " + time_left(static_cast<double>(total - done) / rate);
}

std::string rate_text(double bytes_per_second)
{
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.1f KB/s", bytes_per_second / 1000);
    return text.data();
}

}

std::string progress_text(std::size_t done, std::size_t total, std::chrono::duration<double> elapsed)
{
    done = std::min(done, total);
    std::string text = share_text(done, total);
    if (elapsed.count() < min_rate_seconds || done == 0)
        return text;
    const double rate = static_cast<double>(done) / elapsed.count();
    return text + "  " + rate_text(rate) + rest_text(done, total, rate);
}

std::string work_text(std::size_t done, std::size_t total, std::chrono::duration<double> elapsed)
{
    done = std::min(done, total);
    std::string text = share_text(done, total);
    if (elapsed.count() < min_rate_seconds || done == 0)
        return text;
    return text + rest_text(done, total, static_cast<double>(done) / elapsed.count());
}

namespace {

constexpr std::chrono::seconds before_first_drawing{1};

}

void WorkBar::report(std::size_t done, std::size_t total)
{
    if (!line_.is_seen() || total == 0)
        return;
    const Clock::time_point now = Clock::now();
    if (now - begin_ < before_first_drawing || now - drawn_ < between_drawings)
        return;
    drawn_ = now;
    line_.show(what_ + ' ' + work_text(done, total, now - begin_));
}

}
