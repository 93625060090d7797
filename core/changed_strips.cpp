#include "core/changed_strips.hpp"

#include "core/sweep.hpp"
#include "core/work.hpp"

#include <algorithm>

namespace kfast {

using Kind = PaintStep::Kind;
using StepChange = PaintStep::Change;

/// Sweeps both pictures over single rows.
class RowSearch {
public:
    RowSearch(TracedPicture& shown, TracedPicture& coming, CoverageRow& coverage,
              std::span<CoveredSpan> storage, int width)
        : shown_{shown}, coming_{coming}, coverage_{coverage}, storage_{storage}, width_{width},
          has_vanished_{std::ranges::any_of(
              shown.steps(), [](const PaintStep& step) { return step.partner == PaintStep::no_partner; })}
    {
    }

    /// Stores what the changing layers of the coming picture cover of `row` from `first` on, and marks what
    /// changes. Returns the end of the spans; has_room() tells whether these are all.
    std::uint16_t search(int row, std::uint16_t first, RunList& changed)
    {
        did(Work::searched_row);
        did(Work::step_visit, static_cast<std::uint32_t>(coming_.step_count));
        end_ = first;
        for (std::size_t i = 0; i < coming_.step_count; ++i) {
            const PaintStep& step = coming_.steps()[i];
            if (!step.changes(row))
                continue;
            work_for(step.item);
            const std::uint16_t begin = end_;
            coming_borders_.count = 0;
            const bool runs_through = sweep(i, row);
            if (step.change == StepChange::outlines)
                compare(shown_.steps()[step.partner], row, runs_through, spans_from(begin), changed);
            else
                mark_all(step, row, spans_from(begin), changed);
        }
        if (has_vanished_) {
            did(Work::step_visit, static_cast<std::uint32_t>(shown_.step_count));
            for (PaintStep& step : shown_.steps())
                if (step.partner == PaintStep::no_partner)
                    mark_shown(step, row, changed);
        }
        work_for(0);
        return end_;
    }

    bool has_room() const { return has_room_; }

private:
    /// Whether the borders of the layer run through the row.
    bool sweep(std::size_t number, int row)
    {
        Layer& layer = coming_.steps()[number].layer;
        if (!layer.reaches(row))
            return true;
        const bool runs_through = sweep_row(coming_.outlines, layer, row, coverage_, coming_borders_, true);
        CoveredSpan* at = storage_.data() + end_;
        CoveredSpan* const last = storage_.data() + storage_.size();
        bool has_room = true;
        coverage_.take_spans([&](int begin, int end, std::int32_t level) {
            if (at != last)
                *at++ = {static_cast<std::int16_t>(begin), static_cast<std::int16_t>(end),
                         static_cast<std::uint16_t>(number), static_cast<std::uint8_t>(level)};
            else
                has_room = false;
        });
        end_ = static_cast<std::uint16_t>(at - storage_.data());
        has_room_ = has_room_ && has_room;
        return runs_through;
    }

    std::span<const CoveredSpan> spans_from(std::uint16_t begin) const
    {
        return storage_.subspan(begin, end_ - begin);
    }

    void compare(PaintStep& before, int row, bool coming_runs_through, std::span<const CoveredSpan> spans,
                 RunList& changed)
    {
        bool runs_through = true;
        shown_borders_.count = 0;
        if (before.layer.reaches(row))
            runs_through = sweep_row(shown_.outlines, before.layer, row, coverage_, shown_borders_,
                                     !coming_runs_through);
        if (runs_through && coming_runs_through)
            return mark_between(shown_borders_.list(), coming_borders_.list(), width_, changed);
        SpanComparison comparison{spans, changed};
        coverage_.take_spans(
            [&](int begin, int end, std::int32_t level) { comparison.take(begin, end, level); });
        comparison.finish(width_);
    }

    void mark_all(const PaintStep& step, int row, std::span<const CoveredSpan> spans, RunList& changed)
    {
        for (const CoveredSpan& span : spans)
            changed.add(span.begin, span.end);
        if (step.partner != PaintStep::no_partner)
            mark_shown(shown_.steps()[step.partner], row, changed);
    }

    void mark_shown(PaintStep& before, int row, RunList& changed)
    {
        if (!before.layer.reaches(row))
            return;
        sweep_row(shown_.outlines, before.layer, row, coverage_);
        coverage_.take_spans([&](int begin, int end, std::int32_t) { changed.add(begin, end); });
    }

    TracedPicture& shown_;
    TracedPicture& coming_;
    CoverageRow& coverage_;
    std::span<CoveredSpan> storage_;
    int width_;
    bool has_vanished_; ///< a step of the shown picture
    Crossings coming_borders_;
    Crossings shown_borders_;
    std::uint16_t end_ = 0;
    bool has_room_ = true;
};

namespace {

/// Without division, which costs a Cortex-M0 a call, where places are not bound.
int rounded_down(int value, int unit) { return unit == 1 ? value : value - value % unit; }
int rounded_up(int value, int unit) { return rounded_down(value + unit - 1, unit); }

/// In whole units, and joined where a gap costs less than another area.
RunList widened(const RunList& columns, int width, const AreaRules& rules)
{
    RunList wide{std::max(rules.overhead, 1)};
    for (const Run& run : columns.runs())
        wide.add(rounded_down(run.begin, rules.granularity.width),
                 std::min(rounded_up(run.end, rules.granularity.width), width));
    return wide;
}

int cost(const RunList& columns, int rows, const AreaRules& rules)
{
    return columns.width() * rows + static_cast<int>(columns.runs().size()) * rules.overhead;
}

RunList joined(const RunList& a, const RunList& b)
{
    RunList both = a;
    for (const Run& run : b.runs())
        both.add(run.begin, run.end);
    return both;
}

/// Whether each of `runs` lies within one of `outer`.
bool lie_within(std::span<const Run> runs, std::span<const Run> outer)
{
    auto at = outer.begin();
    for (const Run& run : runs) {
        while (at != outer.end() && at->end < run.end)
            ++at;
        if (at == outer.end() || at->begin > run.begin)
            return false;
    }
    return true;
}

}

void ChangedStrips::begin(const TracedPicture& shown, const TracedPicture& coming)
{
    row_ = panel_.height;
    bottom_ = 0;
    rejected_rows_ = 0;
    strip_ = {};
    for (const TracedPicture* picture : {&shown, &coming})
        for (const PaintStep& step : picture->steps())
            if (step.change != StepChange::none && step.layer.top < step.layer.bottom) {
                row_ = std::min<int>(row_, step.layer.top);
                bottom_ = std::max<int>(bottom_, step.layer.bottom);
            }
    bottom_ = std::min(bottom_, panel_.height);
}

const Strip& ChangedStrips::next(TracedPicture& shown, TracedPicture& coming, CoverageRow& coverage,
                                 const AreaRules& rules)
{
    begin_strip(rules);
    RowSearch search{shown, coming, coverage, storage_, panel_.width};
    row_ = rounded_down(row_, rules.granularity.height);
    while (row_ < bottom_ && strip_.rows + rules.granularity.height <= Strip::most_rows &&
           (strip_.rows == 0 || ends_[static_cast<std::size_t>(strip_.rows)] <= storage_.size() / 2))
        if (!add_group(search, rules))
            break;
    return strip_;
}

/// With the group that was not worth joining the last strip.
void ChangedStrips::begin_strip(const AreaRules& rules)
{
    const auto first = static_cast<std::size_t>(strip_.rows);
    const std::uint16_t shift = ends_[first];
    strip_ = {};
    strip_.columns = RunList{std::max(rules.overhead, 1)};
    ends_[0] = 0;
    if (rejected_rows_ == 0)
        return;
    strip_.top = row_ - rejected_rows_;
    strip_.rows = rejected_rows_;
    strip_.columns = rejected_;
    std::copy(storage_.begin() + shift,
              storage_.begin() + ends_[first + static_cast<std::size_t>(rejected_rows_)], storage_.begin());
    for (std::size_t i = 1; i <= static_cast<std::size_t>(rejected_rows_); ++i)
        ends_[i] = static_cast<std::uint16_t>(ends_[first + i] - shift);
    rejected_rows_ = 0;
}

/// Searches the rows that the panel takes together. Whether the strip may go on behind them.
bool ChangedStrips::add_group(RowSearch& search, const AreaRules& rules)
{
    const int rows = rules.granularity.height;
    RunList changed;
    for (int i = 0; i < rows; ++i) {
        const auto at = static_cast<std::size_t>(strip_.rows + i);
        ends_[at + 1] = search.search(row_ + i, ends_[at], changed);
    }
    if (!search.has_room()) {
        if (strip_.rows == 0)
            draw_whole(rows);
        return false; // else it is searched again, by itself
    }
    row_ += rows;
    if (changed.empty())
        return strip_.rows == 0;
    const RunList columns = widened(changed, panel_.width, rules);
    if (strip_.rows != 0 && !is_worth_joining(columns, rules)) {
        rejected_ = columns;
        rejected_rows_ = rows;
        return false;
    }
    for (const Run& run : columns.runs())
        strip_.columns.add(run.begin, run.end);
    strip_.top = row_ - rows - strip_.rows;
    strip_.rows += rows;
    return true;
}

bool ChangedStrips::is_worth_joining(const RunList& columns, const AreaRules& rules) const
{
    const int rows = rules.granularity.height;
    const int apart = cost(strip_.columns, strip_.rows, rules) + cost(columns, rows, rules);
    const auto is_worth = [&](const RunList& both) {
        return cost(both, strip_.rows + rows, rules) <= apart && finds_room(both, strip_.rows + rows, rules);
    };
    if (lie_within(columns.runs(), strip_.columns.runs())) // mostly
        return is_worth(strip_.columns);
    return is_worth(joined(strip_.columns, columns));
}

/// An area that ends at the panel's edge has rows of whole bytes nevertheless.
bool ChangedStrips::finds_room(const RunList& columns, int rows, const AreaRules& rules) const
{
    const int filling = columns.runs().back().end == panel_.width ? rules.filling : 0;
    return static_cast<std::size_t>((columns.width() + filling) * rows) <= rules.room;
}

void ChangedStrips::draw_whole(int rows)
{
    strip_.top = row_;
    strip_.rows = rows;
    strip_.columns.add(0, panel_.width);
    strip_.has_spans = false;
    row_ += rows;
}

}
