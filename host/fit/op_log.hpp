#pragma once

#include "host/fit/op_counts.hpp"

#include <unordered_map>

namespace kfast::fit {

/// Counts the work that the core does on its thread while it lives; there is only one at a time there.
class OpLog : private OpCounter {
public:
    OpLog();
    ~OpLog() override;
    OpLog(const OpLog&) = delete;

    /// Since the beginning or clear(), by the paths of items; what is done for none of them under 0.
    const std::unordered_map<std::uint32_t, OpCounts>& by_item() const { return counts_by_item_; }
    void clear();

private:
    std::uint32_t* counts_for(std::uint32_t path) override { return counts_by_item_[path].data(); }

    std::unordered_map<std::uint32_t, OpCounts> counts_by_item_;
};

}
