#include "host/commands/progress_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace kfast {
namespace {

constexpr std::size_t bar_width = 20;
/// Before, a rate would say little.
constexpr double telling_seconds = 0.1;

std::string bar(std::size_t done, std::size_t total)
{
    const std::size_t marks = bar_width * done / total;
    return '[' + std::string(marks, '#') + std::string(bar_width - marks, ' ') + ']';
}

std::string time_left(double seconds)
{
    const auto whole = static_cast<long>(std::ceil(std::min(seconds, 360'000.0)));
    if (whole < 60)
        return std::to_string(whole) + " s left";
    return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s left";
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
    std::array<char, 16> share{};
    std::snprintf(share.data(), share.size(), "  %3zu %%", 100 * done / total);
    std::string text = bar(done, total) + share.data();
    if (elapsed.count() < telling_seconds || done == 0)
        return text;
    const double rate = static_cast<double>(done) / elapsed.count();
    text += "  " + rate_text(rate);
    return done == total ? text : text + "  " + time_left(static_cast<double>(total - done) / rate);
}

}
