#pragma once

#include "firmware/report.hpp"

#include <array>
#include <cstddef>

namespace kfast::usb {

/// Reports on their way, first in, first out.
template <std::size_t room>
class ReportRing {
public:
    bool is_empty() const { return count_ == 0; }
    std::size_t free() const { return room - count_; }

    /// Where the next report is to be put; it counts from push() on. Must have something free().
    Report& next() { return reports_[(first_ + count_) % room]; }
    void push() { ++count_; }

    /// Must not be empty.
    const Report& first() const { return reports_[first_]; }
    void pop()
    {
        first_ = (first_ + 1) % room;
        --count_;
    }

    void clear() { count_ = 0; }

private:
    alignas(4) std::array<Report, room> reports_{};
    std::size_t first_ = 0;
    std::size_t count_ = 0;
};

}
