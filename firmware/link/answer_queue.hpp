#pragma once

#include "core/bytes/expects.hpp"
#include "firmware/report.hpp"

#include <array>
#include <cstddef>
#include <optional>

namespace kfast::link {

/// Reports that wait until the computer fetches them, the first first.
class AnswerQueue {
public:
    static constexpr std::size_t max = 8;

    bool is_empty() const { return count_ == 0; }
    bool is_full() const { return count_ == max; }

    /// Must not be full.
    void put(const Report& report)
    {
        expects(!is_full());
        reports_[(first_ + count_++) % max] = report;
    }

    std::optional<Report> next()
    {
        if (is_empty())
            return std::nullopt;
        const std::size_t place = first_;
        first_ = (first_ + 1) % max;
        --count_;
        return reports_[place];
    }

private:
    std::array<Report, max> reports_{};
    std::size_t first_ = 0;
    std::size_t count_ = 0;
};

}
