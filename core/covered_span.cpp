#include "core/covered_span.hpp"
#include "core/work.hpp"

#include <algorithm>

namespace kfast {

void SpanComparison::compare_up_to(int end, int level)
{
    while (x_ < end) {
        did(Work::compared);
        while (!spans_.empty() && spans_.front().end <= x_)
            spans_ = spans_.subspan(1);
        int stop = end;
        int other = 0;
        if (!spans_.empty() && spans_.front().begin <= x_) {
            other = spans_.front().level;
            stop = std::min<int>(end, spans_.front().end);
        } else if (!spans_.empty()) {
            stop = std::min<int>(end, spans_.front().begin);
        }
        if (level != other)
            changed_.add(x_, stop);
        x_ = stop;
    }
}

namespace {

int column_of(Fixed x) { return x.raw() >> 16; }

/// All columns that border on one of two crossings.
void mark(const Crossing& a, const Crossing& b, int width, RunList& changed)
{
    did(Work::marked);
    const Fixed rounding = Fixed::from_raw(32); // CoverageRow rounds x to 1/1024 px
    const int begin = std::max(column_of(std::min(a.left(), b.left())), 0);
    const int end = std::min(column_of(std::max(a.right(), b.right()) + rounding) + 1, width);
    if (begin < end)
        changed.add(begin, end);
}

}

void mark_between(std::span<const Crossing> a, std::span<const Crossing> b, int width, RunList& changed)
{
    if (a.size() == b.size()) {
        for (std::size_t i = 0; i < a.size(); ++i)
            if (a[i] != b[i] || a[i].is_bent)
                mark(a[i], b[i], width, changed);
        return;
    }
    for (const auto& borders : {a, b}) // from the first border to the last
        if (!borders.empty())
            mark(borders.front(), borders.back(), width, changed);
}

}
