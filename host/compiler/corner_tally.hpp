#pragma once

#include "core/work.hpp"

#include <array>
#include <cstdint>
#include <unordered_map>

namespace kfast {

/// Counts the corners of outlines while it lives, also those that find no room; there is only one at a time.
class CornerTally : private WorkTally {
public:
    using ByItem = std::unordered_map<std::uint32_t, std::uint32_t>;

    CornerTally();
    ~CornerTally() override;
    CornerTally(const CornerTally&) = delete;

    /// Of the picture that was traced last, at its coarsest; by the paths of items.
    ByItem by_item() const;

private:
    using Counts = std::array<std::uint32_t, work_kinds>;

    std::uint32_t* counts_for(std::uint32_t path) override;

    std::unordered_map<std::uint32_t, Counts> begun_;
    std::unordered_map<std::uint32_t, Counts> done_;
};

}
