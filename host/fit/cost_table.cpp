// Written by scripts/calibrate.

#include "host/fit/cost_table.hpp"
#include "host/fit/op_counts.hpp"

#include <array>
#include <string_view>

namespace kfast::fit {
namespace {

// What the costs below are of.
constexpr auto kinds = std::to_array<std::string_view>({
    "picture",       "timeline",      "key",        "item",        "track",          "placement",
    "law",           "bezier_law",    "bone",       "object",      "stroke",         "segment",
    "line",          "curve",         "split",      "point",       "wide_point",     "projected_point",
    "carried_point", "bent_point",    "piece",      "pen_piece",   "bend",           "slight_bend",
    "placed_corner", "corner",        "chain",      "crossing",    "kept_chain",     "step",
    "passed_band",   "passed_border", "band",       "band_chain",  "straight_chain", "border",
    "region",        "edge_row",      "flat_pixel", "chain_visit", "layer",          "layer_row",
    "layer_edge",    "bent_edge",     "sum_row",    "row_chain",   "sum_part",       "sum_pixel",
    "edge_group",    "line_crossing", "span",       "fill",        "filled_pixel",   "blended_pixel",
    "faded_pixel",
});
static_assert(kinds == op_names, "the kinds of work have changed: scripts/calibrate");

constexpr std::array<ProcessorCosts, processor_count> table{{
    // cortex-m0
    {
        .code = 81648,
        .bare_code = 57112,
        .feature_code = {2448, 5284, 4676, 5952, 2240, 4144, 888, 608, 1544, 1512, 1500, 580},
        .fixed_ram = 4,
        .stack = 5728,
        .cycles = 1.68,
        .frame = 887,
        .area = 536,
        .work = std::to_array<double>({
            2049.8, // picture
            118.3,  // timeline
            1068.4, // key
            579.6,  // item
            1056.0, // track
            711.9,  // placement
            587.3,  // law
            2987.8, // bezier_law
            847.2,  // bone
            0.0,    // object
            1355.1, // stroke
            783.6,  // segment
            0.0,    // line
            211.6,  // curve
            987.4,  // split
            146.3,  // point
            0.0,    // wide_point
            952.9,  // projected_point
            279.4,  // carried_point
            619.5,  // bent_point
            64.4,   // piece
            451.6,  // pen_piece
            230.0,  // bend
            0.0,    // slight_bend
            195.6,  // placed_corner
            264.3,  // corner
            623.4,  // chain
            7.0,    // crossing
            52.9,   // kept_chain
            302.9,  // step
            85.1,   // passed_band
            0.0,    // passed_border
            554.8,  // band
            328.9,  // band_chain
            378.8,  // straight_chain
            53.1,   // border
            235.2,  // region
            142.1,  // edge_row
            9.5,    // flat_pixel
            44.8,   // chain_visit
            522.6,  // layer
            0.0,    // layer_row
            137.0,  // layer_edge
            311.2,  // bent_edge
            278.2,  // sum_row
            180.1,  // row_chain
            138.7,  // sum_part
            15.7,   // sum_pixel
            0.0,    // edge_group
            152.2,  // line_crossing
            78.1,   // span
            24.3,   // fill
            0.0,    // filled_pixel
            33.6,   // blended_pixel
            49.0,   // faded_pixel
        }),
    },
    // cortex-m3
    {
        .code = 78944,
        .bare_code = 55020,
        .feature_code = {2556, 5036, 4552, 5812, 2164, 3860, 848, 544, 1556, 1540, 1500, 520},
        .fixed_ram = 4,
        .stack = 5560,
        .cycles = 1.79,
        .frame = 427,
        .area = 415,
        .work = std::to_array<double>({
            1584.4, // picture
            91.7,   // timeline
            1034.9, // key
            473.6,  // item
            844.5,  // track
            19.3,   // placement
            235.5,  // law
            1950.9, // bezier_law
            164.9,  // bone
            0.0,    // object
            874.0,  // stroke
            517.0,  // segment
            0.0,    // line
            218.5,  // curve
            849.8,  // split
            108.7,  // point
            0.0,    // wide_point
            416.5,  // projected_point
            253.4,  // carried_point
            535.6,  // bent_point
            42.8,   // piece
            271.4,  // pen_piece
            46.0,   // bend
            0.0,    // slight_bend
            126.9,  // placed_corner
            207.4,  // corner
            483.9,  // chain
            7.2,    // crossing
            40.5,   // kept_chain
            227.6,  // step
            59.1,   // passed_band
            0.0,    // passed_border
            437.7,  // band
            285.0,  // band_chain
            323.8,  // straight_chain
            42.1,   // border
            202.6,  // region
            102.6,  // edge_row
            2.6,    // flat_pixel
            37.1,   // chain_visit
            404.1,  // layer
            0.0,    // layer_row
            109.2,  // layer_edge
            214.7,  // bent_edge
            195.9,  // sum_row
            149.4,  // row_chain
            107.3,  // sum_part
            12.2,   // sum_pixel
            0.0,    // edge_group
            119.8,  // line_crossing
            63.9,   // span
            19.6,   // fill
            0.7,    // filled_pixel
            23.5,   // blended_pixel
            33.6,   // faded_pixel
        }),
    },
    // cortex-m4
    {
        .code = 78932,
        .bare_code = 55040,
        .feature_code = {2560, 5024, 4552, 5788, 2164, 3852, 848, 544, 1552, 1536, 1500, 512},
        .fixed_ram = 4,
        .stack = 5560,
        .cycles = 1.79,
        .frame = 428,
        .area = 413,
        .work = std::to_array<double>({
            1587.5, // picture
            91.7,   // timeline
            1034.0, // key
            471.4,  // item
            849.6,  // track
            16.1,   // placement
            235.4,  // law
            1969.9, // bezier_law
            175.7,  // bone
            0.0,    // object
            870.9,  // stroke
            515.9,  // segment
            0.0,    // line
            218.9,  // curve
            846.3,  // split
            107.8,  // point
            0.0,    // wide_point
            417.2,  // projected_point
            252.7,  // carried_point
            535.3,  // bent_point
            43.6,   // piece
            272.5,  // pen_piece
            37.2,   // bend
            0.0,    // slight_bend
            128.6,  // placed_corner
            209.1,  // corner
            489.2,  // chain
            7.2,    // crossing
            40.5,   // kept_chain
            227.7,  // step
            60.2,   // passed_band
            0.0,    // passed_border
            438.3,  // band
            284.6,  // band_chain
            322.2,  // straight_chain
            42.3,   // border
            202.1,  // region
            102.6,  // edge_row
            3.2,    // flat_pixel
            36.9,   // chain_visit
            407.4,  // layer
            0.0,    // layer_row
            108.3,  // layer_edge
            227.8,  // bent_edge
            198.5,  // sum_row
            148.5,  // row_chain
            107.3,  // sum_part
            11.6,   // sum_pixel
            0.0,    // edge_group
            119.6,  // line_crossing
            64.8,   // span
            19.9,   // fill
            0.7,    // filled_pixel
            23.6,   // blended_pixel
            32.6,   // faded_pixel
        }),
    },
    // cortex-m7
    {
        .code = 78992,
        .bare_code = 55100,
        .feature_code = {2576, 5020, 4544, 5784, 2168, 3848, 848, 544, 1552, 1536, 1500, 516},
        .fixed_ram = 4,
        .stack = 5552,
        .cycles = 1.66,
        .frame = 424,
        .area = 428,
        .work = std::to_array<double>({
            1582.2, // picture
            91.7,   // timeline
            1034.8, // key
            475.3,  // item
            842.7,  // track
            24.6,   // placement
            235.3,  // law
            1950.4, // bezier_law
            169.5,  // bone
            0.0,    // object
            875.1,  // stroke
            516.3,  // segment
            0.0,    // line
            218.5,  // curve
            845.8,  // split
            108.8,  // point
            0.0,    // wide_point
            415.5,  // projected_point
            252.5,  // carried_point
            535.4,  // bent_point
            42.8,   // piece
            271.5,  // pen_piece
            46.6,   // bend
            0.0,    // slight_bend
            127.0,  // placed_corner
            207.4,  // corner
            483.8,  // chain
            7.2,    // crossing
            40.5,   // kept_chain
            229.2,  // step
            60.0,   // passed_band
            0.0,    // passed_border
            438.0,  // band
            285.9,  // band_chain
            323.5,  // straight_chain
            42.4,   // border
            194.5,  // region
            106.0,  // edge_row
            1.9,    // flat_pixel
            37.2,   // chain_visit
            395.7,  // layer
            0.0,    // layer_row
            110.3,  // layer_edge
            221.2,  // bent_edge
            200.2,  // sum_row
            149.6,  // row_chain
            110.2,  // sum_part
            14.0,   // sum_pixel
            0.0,    // edge_group
            118.1,  // line_crossing
            58.7,   // span
            20.5,   // fill
            0.8,    // filled_pixel
            24.5,   // blended_pixel
            33.7,   // faded_pixel
        }),
    },
    // cortex-m33
    {
        .code = 78940,
        .bare_code = 55044,
        .feature_code = {2560, 5028, 4552, 5800, 2164, 3856, 848, 544, 1556, 1540, 1500, 520},
        .fixed_ram = 4,
        .stack = 5560,
        .cycles = 1.79,
        .frame = 427,
        .area = 415,
        .work = std::to_array<double>({
            1584.1, // picture
            91.7,   // timeline
            1034.7, // key
            473.8,  // item
            844.2,  // track
            20.3,   // placement
            235.5,  // law
            1950.9, // bezier_law
            170.9,  // bone
            0.0,    // object
            873.0,  // stroke
            516.4,  // segment
            0.0,    // line
            218.6,  // curve
            845.8,  // split
            108.7,  // point
            0.0,    // wide_point
            416.5,  // projected_point
            252.5,  // carried_point
            535.0,  // bent_point
            42.8,   // piece
            271.4,  // pen_piece
            45.9,   // bend
            0.0,    // slight_bend
            127.0,  // placed_corner
            207.4,  // corner
            483.9,  // chain
            7.2,    // crossing
            40.5,   // kept_chain
            227.9,  // step
            60.2,   // passed_band
            0.0,    // passed_border
            437.9,  // band
            285.0,  // band_chain
            323.8,  // straight_chain
            42.2,   // border
            202.5,  // region
            102.7,  // edge_row
            2.6,    // flat_pixel
            37.1,   // chain_visit
            404.5,  // layer
            0.0,    // layer_row
            109.2,  // layer_edge
            214.7,  // bent_edge
            195.8,  // sum_row
            149.4,  // row_chain
            107.3,  // sum_part
            12.3,   // sum_pixel
            0.0,    // edge_group
            119.8,  // line_crossing
            63.9,   // span
            19.6,   // fill
            0.7,    // filled_pixel
            23.5,   // blended_pixel
            33.6,   // faded_pixel
        }),
    },
}};

}

const ProcessorCosts& costs_of(Processor processor) { return table[static_cast<std::size_t>(processor)]; }

}
