#include "core/run_list.hpp"
#include "core/work.hpp"

namespace kfast {

int RunList::width() const
{
    int sum = 0;
    for (const Run& run : runs())
        sum += run.width();
    return sum;
}

void RunList::insert(Run run)
{
    did(Work::inserted_run);
    std::size_t at = count_;
    while (at > 0 && runs_[at - 1].begin > run.begin)
        --at;
    if (at > 0 && run.begin < runs_[at - 1].end + gap_) {
        --at;
        run = {runs_[at].begin, std::max(runs_[at].end, run.end)};
    } else {
        std::copy_backward(runs_.begin() + at, runs_.begin() + count_, runs_.begin() + count_ + 1);
        ++count_;
    }
    std::size_t behind = at + 1;
    while (behind < count_ && runs_[behind].begin < run.end + gap_)
        run.end = std::max(run.end, runs_[behind++].end);
    runs_[at] = run;
    std::copy(runs_.begin() + behind, runs_.begin() + count_, runs_.begin() + at + 1);
    count_ = static_cast<std::uint16_t>(count_ - (behind - at - 1));
    if (count_ > most)
        join_nearest();
}

void RunList::join_nearest()
{
    std::size_t nearest = 1;
    const auto gap_before = [this](std::size_t i) { return runs_[i].begin - runs_[i - 1].end; };
    for (std::size_t i = 2; i < count_; ++i)
        if (gap_before(i) < gap_before(nearest))
            nearest = i;
    runs_[nearest - 1].end = runs_[nearest].end;
    std::copy(runs_.begin() + nearest + 1, runs_.begin() + count_, runs_.begin() + nearest);
    --count_;
}

}
