#pragma once

#include "core/work.hpp"

#include <array>
#include <string_view>

namespace kfast::fit {

/// In the order of Work.
inline constexpr std::array<std::string_view, work_kinds> work_names{
    "picture",       "item",          "track",        "key",
    "placement",     "law",           "bezier_law",   "bone",
    "object",        "stroke",        "line",         "curve",
    "split",         "point",         "wide_point",   "projected_point",
    "carried_point", "bent_point",    "piece",        "wide_piece",
    "pen_piece",     "bend",          "slight_bend",  "corner",
    "chain",         "copied_corner", "copied_chain", "strip",
    "searched_row",  "step_visit",    "swept_row",    "straight_part",
    "bent_part",     "edge",          "slab",         "slab_edge",
    "flat_edge",     "crossed_pixel", "cell",         "span",
    "compared",      "marked",        "inserted_run", "fill",
    "filled_pixel",  "blended_pixel", "faded_pixel",
};

static_assert(work_names.back() == "faded_pixel");

}
