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
    std::size_t at = 0;
    while (at < count_ && runs_[at].end + gap_ <= run.begin)
        ++at;
    if (at == count_ || run.end + gap_ <= runs_[at].begin) {
        make_room(at);
        runs_[at] = run;
        if (count_ > most)
            join_nearest();
        return;
    }
    Run& joined = runs_[at];
    joined.begin = std::min(joined.begin, run.begin);
    if (run.end <= joined.end)
        return;
    std::size_t behind = at + 1;
    for (; behind < count_ && runs_[behind].begin < run.end + gap_; ++behind)
        run.end = std::max(run.end, runs_[behind].end);
    joined.end = run.end;
    close_gap(at + 1, behind);
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
