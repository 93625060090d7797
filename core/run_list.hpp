#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// A stretch of columns of a row, its end not included.
struct alignas(4) Run { // a word is copied by a load and a store, two halves by a call
    std::int16_t begin;
    std::int16_t end;

    constexpr int width() const { return end - begin; }
    friend constexpr bool operator==(Run, Run) = default;
};

/// Runs from left to right that neither touch nor overlap, a few at most: those that are nearest to each
/// other become one where there would be more.
class RunList {
public:
    static constexpr std::size_t most = 12;

    /// Runs with fewer than `gap` columns between them are one.
    explicit RunList(int gap) : gap_{static_cast<std::int16_t>(gap)} {}
    RunList() : RunList{1} {}

    /// 0 <= begin < end <= 4098.
    void add(int begin, int end)
    {
        const Run run{static_cast<std::int16_t>(begin), static_cast<std::int16_t>(end)};
        if (count_ == 0)
            return append(run);
        Run& last = runs_[count_ - 1U];
        if (begin >= last.end + gap_) // mostly they come from left to right
            append(run);
        else if (begin >= last.begin)
            last.end = std::max(last.end, run.end);
        else
            insert(run);
    }

    void clear() { count_ = 0; }
    bool empty() const { return count_ == 0; }
    std::span<const Run> runs() const { return {runs_.data(), count_}; }
    /// Columns of all runs.
    int width() const;

    RunList(const RunList& other) : count_{other.count_}, gap_{other.gap_}
    {
        std::copy_n(other.runs_.data(), count_, runs_.data());
    }
    RunList& operator=(const RunList& other)
    {
        count_ = other.count_;
        gap_ = other.gap_;
        std::copy_n(other.runs_.data(), count_, runs_.data());
        return *this;
    }

private:
    void append(Run run)
    {
        if (count_ == most)
            return insert(run);
        runs_[count_++] = run;
    }
    void insert(Run run);
    void make_room(std::size_t at);
    void close_gap(std::size_t at, std::size_t behind);
    void join_nearest();

    std::array<Run, most + 1> runs_; // not initialized: a list is made for every row
    std::uint16_t count_ = 0;
    std::int16_t gap_;
};

}
