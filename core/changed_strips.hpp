#pragma once

#include "core/coverage_row.hpp"
#include "core/covered_span.hpp"
#include "core/run_list.hpp"
#include "core/size.hpp"
#include "core/traced_picture.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// Rows that a panel may take together.
inline constexpr int tallest_group = 8;

/// What areas of a panel have to be like, and what they cost.
struct AreaRules {
    /// Places and sizes are multiples of this, but where the panel ends; no higher than tallest_group.
    Size granularity{.width = 1, .height = 1};
    int overhead = 0;     ///< of each area, in pixels
    std::size_t room = 0; ///< pixels that areas drawn together have; at least granularity.height rows
    int filling = 0;      ///< pixels that the last byte of a row of the panel has room for behind its end
};

/// Rows that are drawn together, all in the same columns.
struct Strip {
    static constexpr int most_rows = 16;

    int top = 0;
    int rows = 0; ///< 0 when nothing is left
    RunList columns = {};
    bool has_spans = true; ///< else there were too many, and the rows must be swept again
};

/// Finds the areas in which two pictures differ, strip by strip from the top down, and what covers them in
/// the coming one: the outlines of both are swept together.
class ChangedStrips {
public:
    /// `storage` is for the spans. A row that has more of them is not lost, but swept twice.
    ChangedStrips(std::span<CoveredSpan> storage, Size panel) : storage_{storage}, panel_{panel} {}

    /// From the top; the pictures are matched.
    void begin(const TracedPicture& shown, const TracedPicture& coming);
    /// With the same pictures, which differ from begin() in their sweeps only. `coverage` is empty.
    const Strip& next(TracedPicture& shown, TracedPicture& coming, CoverageRow& coverage,
                      const AreaRules& rules);
    /// What changing layers cover of row `row` of the last strip, step by step.
    std::span<const CoveredSpan> spans(int row) const
    {
        const auto i = static_cast<std::size_t>(row);
        return storage_.subspan(ends_[i], ends_[i + 1] - ends_[i]);
    }

private:
    void begin_strip(const AreaRules& rules);
    bool add_group(class RowSearch& search, const AreaRules& rules);
    bool is_worth_joining(const RunList& columns, const AreaRules& rules) const;
    bool finds_room(const RunList& columns, int rows, const AreaRules& rules) const;
    void draw_whole(int rows);

    std::span<CoveredSpan> storage_;
    Size panel_;
    int row_ = 0;    ///< the next one to be searched
    int bottom_ = 0; ///< nothing moves from here on
    Strip strip_;
    /// Spans of the rows of the strip, and of the group behind it, end here in the storage; ends_[0] is 0.
    std::array<std::uint16_t, Strip::most_rows + tallest_group + 1> ends_{};
    RunList rejected_; ///< of a group that was searched, but not worth joining the strip
    int rejected_rows_ = 0;
};

}
