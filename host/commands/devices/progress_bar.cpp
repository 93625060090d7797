#include "host/commands/devices/progress_bar.hpp"

#include "host/commands/text/progress_text.hpp"

#include <numeric>
#include <utility>

namespace kfast {
namespace {

}

ProgressBar::ProgressBar(std::size_t bytes, std::size_t devices, Shown shown, std::string what)
    : done_(devices), total_{bytes * devices}, is_shown_{shown == Shown::on_a_terminal && line_.is_seen()},
      begin_{Driver::now()}, drawn_{begin_ - between_drawings}, what_{std::move(what)}
{
}

ByteProgressCallback ProgressBar::of_device(std::size_t index)
{
    return [this, index](std::size_t bytes) { report(index, bytes); };
}

void ProgressBar::report(std::size_t index, std::size_t bytes)
{
    if (!is_shown_)
        return;
    const std::lock_guard lock{mutex_};
    done_[index] = bytes;
    const std::size_t done = std::accumulate(done_.begin(), done_.end(), std::size_t{0});
    if (done == total_ || Driver::now() - drawn_ >= between_drawings)
        draw(done);
}

void ProgressBar::draw(std::size_t done)
{
    drawn_ = Driver::now();
    line_.show(what_ + progress_text(done, total_, drawn_ - begin_));
}

}
