#pragma once

#include "core/run_list.hpp"
#include "core/sweep.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// A stretch of a row that a layer covers evenly.
struct CoveredSpan {
    std::int16_t begin = 0;
    std::int16_t end = 0;   ///< the column behind it
    std::uint16_t step = 0; ///< number of the layer's step
    std::uint8_t level = 0; ///< 1 … 255
};

static_assert(sizeof(CoveredSpan) == 8);

/// Marks where two coverages of a row differ. One is given as a list of spans, the other span by span from
/// left to right.
class SpanComparison {
public:
    SpanComparison(std::span<const CoveredSpan> spans, RunList& changed) : spans_{spans}, changed_{changed} {}

    void take(int begin, int end, int level)
    {
        compare_up_to(begin, 0);
        compare_up_to(end, level);
    }

    /// After the last span; the row has `width` columns.
    void finish(int width) { compare_up_to(width, 0); }

private:
    void compare_up_to(int end, int level);

    std::span<const CoveredSpan> spans_;
    RunList& changed_;
    int x_ = 0; ///< what lies to the left of it has been compared
};

/// Marks where the coverages differ of two layers whose borders run through a row of `width` columns: nowhere
/// but between a border of one and that of the other that stands in its place.
void mark_between(std::span<const Crossing> a, std::span<const Crossing> b, int width, RunList& changed);

}
