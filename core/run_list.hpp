#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// A stretch of columns of a row, its end not included.
struct Run {
    std::int16_t begin = 0;
    std::int16_t end = 0;

    constexpr int width() const { return end - begin; }
    friend constexpr bool operator==(Run, Run) = default;
};

/// Runs from left to right that neither touch nor overlap, a few at most: those that are nearest to each
/// other become one where there would be more.
class RunList {
public:
    static constexpr std::size_t most = 12;

    RunList() = default;
    /// Runs with fewer than `gap` columns between them are one.
    explicit RunList(int gap) : gap_{static_cast<std::int16_t>(gap)} {}

    /// 0 <= begin < end <= 4098.
    void add(int begin, int end)
    {
        const Run run{static_cast<std::int16_t>(begin), static_cast<std::int16_t>(end)};
        Run* const last = runs_.data() + count_ - 1;
        const bool is_behind = count_ == 0 || begin >= last->end + gap_;
        if (is_behind && count_ < most) // mostly they come from left to right
            runs_[count_++] = run;
        else if (!is_behind && begin >= last->begin)
            last->end = std::max(last->end, run.end);
        else
            insert(run);
    }

    void clear() { count_ = 0; }
    bool empty() const { return count_ == 0; }
    std::span<const Run> runs() const { return {runs_.data(), count_}; }
    /// Columns of all runs.
    int width() const;

private:
    void insert(Run run);
    void join_nearest();

    std::array<Run, most + 1> runs_;
    std::size_t count_ = 0;
    std::int16_t gap_ = 1;
};

}
