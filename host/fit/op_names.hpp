#pragma once

#include "core/bytes/op_counter.hpp"

#include <array>
#include <string_view>

namespace kfast::fit {

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

}
