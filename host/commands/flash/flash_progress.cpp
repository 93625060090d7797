#include "host/commands/flash/flash_progress.hpp"

#include "host/text/counted.hpp"

#include <iostream>
#include <string>
#include <unistd.h>

namespace kfast {
namespace {

std::string word_of(FlashPhase phase)
{
    switch (phase) {
    case FlashPhase::comparing:
        return "comparing";
    case FlashPhase::writing:
        return "writing";
    case FlashPhase::verifying:
        return "verifying";
    }
    return {};
}

}

void FlashProgress::report(FlashPhase phase, std::size_t done, std::size_t total)
{
    if (shown_ == ProgressBar::Shown::no)
        return;
    if (phase != phase_)
        begin(phase, total);
    if (bar_)
        bar_->of_device(0)(done * FlashImage::sector_bytes);
}

void FlashProgress::begin(FlashPhase phase, std::size_t total)
{
    constexpr std::size_t width = std::string_view{"verifying "}.size();
    phase_ = phase;
    bar_.reset();
    std::string what = word_of(phase);
    if (::isatty(STDERR_FILENO) == 1)
        bar_.emplace(total * FlashImage::sector_bytes, 1, shown_, what.append(width - what.size(), ' '));
    else
        std::cerr << what << ' ' << counted(total, "sector") << '\n';
}

}
