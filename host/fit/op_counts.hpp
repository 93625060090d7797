#pragma once

#include "core/bytes/op_counter.hpp"

#include <array>
#include <cstdint>
#include <string_view>
#include <unordered_map>

namespace kfast::fit {

/// How often each kind of work was done.
using OpCounts = std::array<std::uint32_t, op_kinds>;

inline OpCounts& operator+=(OpCounts& sum, const OpCounts& more)
{
    for (std::size_t kind = 0; kind < op_kinds; ++kind)
        sum[kind] += more[kind];
    return sum;
}

/// In the order of Op.
inline constexpr std::array<std::string_view, op_kinds> op_names{
    "picture",       "timeline",      "key",        "item",        "track",          "placement",
    "law",           "bezier_law",    "bone",       "object",      "stroke",         "segment",
    "line",          "curve",         "split",      "point",       "wide_point",     "projected_point",
    "carried_point", "bent_point",    "piece",      "pen_piece",   "bend",           "slight_bend",
    "placed_corner", "corner",        "chain",      "crossing",    "kept_chain",     "step",
    "passed_band",   "passed_border", "band",       "band_chain",  "straight_chain", "border",
    "region",        "edge_row",      "flat_pixel", "chain_visit", "layer",          "layer_row",
    "layer_edge",    "bent_edge",     "sum_row",    "row_chain",   "sum_part",       "sum_pixel",
    "edge_group",    "line_crossing", "span",       "fill",        "filled_pixel",   "blended_pixel",
    "faded_pixel"};

static_assert(op_names.back() == "faded_pixel");

/// Counts the work that the core does on its thread while it lives; there is only one at a time there.
class OpLog : private OpCounter {
public:
    OpLog();
    ~OpLog() override;
    OpLog(const OpLog&) = delete;

    /// The counts since the beginning or clear(), by the paths of items; what is done for none is under 0.
    const std::unordered_map<std::uint32_t, OpCounts>& by_item() const { return counts_by_item_; }
    void clear();

private:
    std::uint32_t* counts_for(std::uint32_t path) override { return counts_by_item_[path].data(); }

    std::unordered_map<std::uint32_t, OpCounts> counts_by_item_;
};

}
