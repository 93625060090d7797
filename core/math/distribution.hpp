#pragma once

#include <cstdint>

namespace kfast {

/// `total` things handed out to `count` receivers as evenly as the original KFAST did it: everybody gets
/// total div count, and the first total mod count of them one more. `count` is at least 1.
struct Distribution {
    std::uint32_t each = 0;
    std::uint32_t extra = 0;

    constexpr Distribution() = default;
    constexpr Distribution(std::uint32_t total, std::uint32_t count) : each{1}
    {
        if (total == count) // most are, and small processors divide by a function
            return;
        each = total / count;
        extra = total % count;
    }

    /// What receiver `index` (from 0) gets.
    constexpr std::uint32_t at(std::uint32_t index) const { return each + (index < extra ? 1 : 0); }
};

}
