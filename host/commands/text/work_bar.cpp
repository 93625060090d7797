#include "host/commands/text/work_bar.hpp"

#include "host/commands/text/progress_text.hpp"

namespace kfast {
namespace {

constexpr std::chrono::seconds before_first_drawing{1};

}

void WorkBar::report(std::size_t done, std::size_t total)
{
    if (!line_.is_seen() || total == 0)
        return;
    const Driver::time_point now = Driver::now();
    if (now - begin_ < before_first_drawing || now - drawn_ < between_drawings)
        return;
    drawn_ = now;
    line_.show(what_ + ' ' + work_text(done, total, now - begin_));
}

}
