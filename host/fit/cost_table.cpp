// Written by scripts/calibrate.

#include "host/fit/cost_table.hpp"
#include "host/fit/work_names.hpp"

#include <array>
#include <string_view>

namespace kfast::fit {
namespace {

// What the costs below are of.
constexpr auto kinds = std::to_array<std::string_view>({
    "picture",       "item",
    "track",         "key",
    "placement",     "law",
    "bezier_law",    "bone",
    "object",        "stroke",
    "line",          "curve",
    "split",         "point",
    "wide_point",    "projected_point",
    "carried_point", "bent_point",
    "piece",         "wide_piece",
    "pen_piece",     "bend",
    "slight_bend",   "corner",
    "chain",         "crossing",
    "step",          "band",
    "band_chain",    "straight_chain",
    "border",        "region",
    "edge_row",      "flat_pixel",
    "chain_visit",   "layer",
    "layer_row",     "layer_edge",
    "sum_row",       "row_chain",
    "sum_part",      "sum_pixel",
    "edge_group",    "line_crossing",
    "span",          "fill",
    "filled_pixel",  "blended_pixel",
    "faded_pixel",
});
static_assert(kinds == work_names, "the kinds of work have changed: scripts/calibrate");

constexpr std::array<ProcessorCosts, processor_count> table{{
    // cortex-m0
    {
        .code = 64944,
        .fixed_ram = 4,
        .stack = 8688,
        .cycles = 1.76,
        .frame = 789,
        .area = 598,
        .work = std::to_array<double>({
            0.0,    // picture
            6329.4, // item
            2943.2, // track
            1066.7, // key
            0.0,    // placement
            1887.6, // law
            2735.0, // bezier_law
            81.3,   // bone
            0.0,    // object
            1582.3, // stroke
            113.3,  // line
            1426.5, // curve
            759.6,  // split
            5.9,    // point
            0.0,    // wide_point
            1068.0, // projected_point
            564.6,  // carried_point
            1163.8, // bent_point
            131.1,  // piece
            72.4,   // wide_piece
            327.5,  // pen_piece
            189.2,  // bend
            0.0,    // slight_bend
            309.4,  // corner
            438.3,  // chain
            14.3,   // crossing
            701.1,  // step
            291.0,  // band
            369.0,  // band_chain
            337.3,  // straight_chain
            214.2,  // border
            234.5,  // region
            261.6,  // edge_row
            5.6,    // flat_pixel
            0.0,    // chain_visit
            665.0,  // layer
            0.0,    // layer_row
            202.1,  // layer_edge
            220.9,  // sum_row
            225.5,  // row_chain
            75.3,   // sum_part
            40.7,   // sum_pixel
            28.6,   // edge_group
            159.4,  // line_crossing
            40.7,   // span
            0.0,    // fill
            3.0,    // filled_pixel
            39.9,   // blended_pixel
            49.5,   // faded_pixel
        }),
    },
    // cortex-m3
    {
        .code = 61452,
        .fixed_ram = 4,
        .stack = 8504,
        .cycles = 1.88,
        .frame = 401,
        .area = 329,
        .work = std::to_array<double>({
            0.0,    // picture
            3690.6, // item
            1391.7, // track
            458.8,  // key
            0.0,    // placement
            842.8,  // law
            1677.3, // bezier_law
            0.0,    // bone
            341.9,  // object
            680.4,  // stroke
            53.4,   // line
            1148.2, // curve
            507.4,  // split
            13.4,   // point
            0.0,    // wide_point
            276.4,  // projected_point
            381.1,  // carried_point
            666.7,  // bent_point
            83.2,   // piece
            0.0,    // wide_piece
            184.3,  // pen_piece
            16.5,   // bend
            0.0,    // slight_bend
            249.9,  // corner
            356.1,  // chain
            13.0,   // crossing
            506.7,  // step
            214.1,  // band
            349.7,  // band_chain
            267.7,  // straight_chain
            220.9,  // border
            149.5,  // region
            175.9,  // edge_row
            0.0,    // flat_pixel
            0.0,    // chain_visit
            661.6,  // layer
            0.0,    // layer_row
            99.5,   // layer_edge
            429.5,  // sum_row
            114.8,  // row_chain
            0.0,    // sum_part
            33.4,   // sum_pixel
            0.0,    // edge_group
            173.0,  // line_crossing
            44.9,   // span
            5.2,    // fill
            4.0,    // filled_pixel
            26.4,   // blended_pixel
            33.7,   // faded_pixel
        }),
    },
    // cortex-m4
    {
        .code = 61516,
        .fixed_ram = 4,
        .stack = 8504,
        .cycles = 1.88,
        .frame = 400,
        .area = 330,
        .work = std::to_array<double>({
            0.0,    // picture
            3735.4, // item
            1394.5, // track
            458.9,  // key
            0.0,    // placement
            839.3,  // law
            1669.0, // bezier_law
            0.0,    // bone
            296.4,  // object
            671.2,  // stroke
            51.3,   // line
            1147.8, // curve
            504.3,  // split
            12.3,   // point
            0.0,    // wide_point
            278.4,  // projected_point
            380.8,  // carried_point
            667.5,  // bent_point
            83.4,   // piece
            0.0,    // wide_piece
            184.2,  // pen_piece
            10.5,   // bend
            0.0,    // slight_bend
            252.6,  // corner
            360.1,  // chain
            13.0,   // crossing
            514.2,  // step
            214.0,  // band
            348.3,  // band_chain
            268.1,  // straight_chain
            219.2,  // border
            155.9,  // region
            177.5,  // edge_row
            0.0,    // flat_pixel
            0.0,    // chain_visit
            655.0,  // layer
            0.0,    // layer_row
            102.2,  // layer_edge
            426.1,  // sum_row
            118.0,  // row_chain
            0.0,    // sum_part
            33.4,   // sum_pixel
            0.0,    // edge_group
            171.9,  // line_crossing
            45.2,   // span
            4.1,    // fill
            4.0,    // filled_pixel
            26.2,   // blended_pixel
            32.8,   // faded_pixel
        }),
    },
    // cortex-m7
    {
        .code = 61496,
        .fixed_ram = 4,
        .stack = 8496,
        .cycles = 1.74,
        .frame = 398,
        .area = 329,
        .work = std::to_array<double>({
            0.0,    // picture
            3695.7, // item
            1393.0, // track
            458.7,  // key
            0.0,    // placement
            839.6,  // law
            1676.2, // bezier_law
            0.0,    // bone
            334.0,  // object
            680.9,  // stroke
            52.1,   // line
            1146.6, // curve
            505.4,  // split
            13.4,   // point
            0.0,    // wide_point
            277.5,  // projected_point
            380.3,  // carried_point
            665.7,  // bent_point
            83.2,   // piece
            0.0,    // wide_piece
            184.3,  // pen_piece
            17.0,   // bend
            0.0,    // slight_bend
            250.0,  // corner
            356.3,  // chain
            12.9,   // crossing
            515.2,  // step
            213.9,  // band
            348.5,  // band_chain
            268.0,  // straight_chain
            220.2,  // border
            155.7,  // region
            177.9,  // edge_row
            0.0,    // flat_pixel
            0.0,    // chain_visit
            655.3,  // layer
            0.0,    // layer_row
            102.0,  // layer_edge
            425.6,  // sum_row
            118.0,  // row_chain
            0.0,    // sum_part
            33.3,   // sum_pixel
            0.0,    // edge_group
            171.9,  // line_crossing
            45.1,   // span
            4.0,    // fill
            4.0,    // filled_pixel
            26.2,   // blended_pixel
            33.8,   // faded_pixel
        }),
    },
}};

}

const ProcessorCosts& costs_of(Processor processor) { return table[static_cast<std::size_t>(processor)]; }

}
