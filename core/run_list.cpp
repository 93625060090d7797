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

// Copies run by run: a few are moved at most, and a call costs more than that.
void RunList::insert(Run run)
{
    did(Work::inserted_run);
    std::size_t at = count_;
    while (at > 0 && runs_[at - 1].begin > run.begin)
        --at;
    if (at > 0 && run.end <= runs_[at - 1].end)
        return;
    if (at > 0 && run.begin < runs_[at - 1].end + gap_)
        run = {runs_[--at].begin, std::max(runs_[at].end, run.end)};
    std::size_t behind = at;
    while (behind < count_ && runs_[behind].begin < run.end + gap_)
        run.end = std::max(run.end, runs_[behind++].end);
    if (behind == at)
        make_room(at);
    else
        close_gap(at + 1, behind);
    runs_[at] = run;
    if (count_ > most)
        join_nearest();
}

void RunList::make_room(std::size_t at)
{
    for (std::size_t i = count_++; i > at; --i)
        runs_[i] = runs_[i - 1];
}

/// Drops the runs from `at` on up to `behind`.
void RunList::close_gap(std::size_t at, std::size_t behind)
{
    if (at == behind)
        return;
    for (; behind < count_; ++at, ++behind)
        runs_[at] = runs_[behind];
    count_ = static_cast<std::uint16_t>(at);
}

void RunList::join_nearest()
{
    std::size_t nearest = 1;
    const auto gap_before = [this](std::size_t i) { return runs_[i].begin - runs_[i - 1].end; };
    for (std::size_t i = 2; i < count_; ++i)
        if (gap_before(i) < gap_before(nearest))
            nearest = i;
    runs_[nearest - 1].end = runs_[nearest].end;
    close_gap(nearest, nearest + 1);
}

}
