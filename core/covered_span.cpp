#include "core/covered_span.hpp"

#include <algorithm>

namespace kfast {

void SpanComparison::compare_up_to(int end, int level)
{
    while (x_ < end) {
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

}
