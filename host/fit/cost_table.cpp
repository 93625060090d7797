// Written by scripts/calibrate.

#include "host/fit/cost_table.hpp"
#include "host/fit/op_counts.hpp"

#include <array>
#include <string_view>

namespace kfast::fit {
namespace {

// What the costs below are of.
constexpr auto kinds = std::to_array<std::string_view>({
    "picture",
    "timeline",
    "key",
    "item",
    "track",
    "placement",
    "law",
    "bezier_law",
    "bone",
    "object",
    "stroke",
    "segment",
    "line",
    "curve",
    "split",
    "point",
    "wide_point",
    "projected_point",
    "carried_point",
    "bent_point",
    "piece",
    "pen_piece",
    "bend",
    "slight_bend",
    "placed_corner",
    "corner",
    "chain",
    "crossing",
    "kept_chain",
    "step",
    "passed_band",
    "passed_border",
    "band",
    "band_chain",
    "straight_chain",
    "border",
    "region",
    "edge_row",
    "flat_pixel",
    "chain_visit",
    "layer",
    "layer_row",
    "layer_edge",
    "bent_edge",
    "sum_row",
    "row_chain",
    "sum_part",
    "sum_pixel",
    "edge_group",
    "line_crossing",
    "span",
    "fill",
    "filled_pixel",
    "blended_pixel",
    "faded_pixel",
});
static_assert(kinds == op_names, "the kinds of work have changed: scripts/calibrate");

constexpr std::array<ProcessorCosts, processor_count> table{{
    // cortex-m0
    {
        .code = 85872,
        .bare_code = 57620,
        .feature_code = {2520, 5324, 4604, 5952, 2232, 4184, 884, 608, 1556, 1492, 4900, 516},
        .fixed_ram = 4,
        .stack = 6216,
        .cycles = 1.68,
        .frame = 888,
        .area = 564,
        .work =
            std::to_array<double>({
                2057.0, // picture
                116.9, // timeline
                1140.6, // key
                607.8, // item
                867.6, // track
                1381.0, // placement
                633.6, // law
                2661.6, // bezier_law
                2119.1, // bone
                0.0, // object
                1299.7, // stroke
                796.2, // segment
                0.0, // line
                219.6, // curve
                973.0, // split
                146.6, // point
                0.0, // wide_point
                957.2, // projected_point
                201.7, // carried_point
                629.3, // bent_point
                48.2, // piece
                409.1, // pen_piece
                234.8, // bend
                15.8, // slight_bend
                199.7, // placed_corner
                283.1, // corner
                610.5, // chain
                7.0, // crossing
                52.9, // kept_chain
                318.1, // step
                85.0, // passed_band
                0.0, // passed_border
                544.1, // band
                346.9, // band_chain
                375.7, // straight_chain
                57.1, // border
                253.2, // region
                137.8, // edge_row
                11.1, // flat_pixel
                43.9, // chain_visit
                543.3, // layer
                0.0, // layer_row
                134.4, // layer_edge
                266.8, // bent_edge
                277.4, // sum_row
                181.7, // row_chain
                137.5, // sum_part
                16.5, // sum_pixel
                0.0, // edge_group
                150.8, // line_crossing
                75.8, // span
                20.0, // fill
                0.0, // filled_pixel
                32.8, // blended_pixel
                49.1, // faded_pixel
            }),
    },
    // cortex-m3
    {
        .code = 83220,
        .bare_code = 55536,
        .feature_code = {2652, 5080, 4492, 5808, 2164, 3904, 848, 544, 1572, 1516, 4976, 480},
        .fixed_ram = 4,
        .stack = 6032,
        .cycles = 1.80,
        .frame = 427,
        .area = 443,
        .work =
            std::to_array<double>({
                1586.1, // picture
                89.2, // timeline
                1025.7, // key
                513.6, // item
                543.0, // track
                1078.1, // placement
                276.1, // law
                1672.3, // bezier_law
                1596.5, // bone
                0.0, // object
                838.4, // stroke
                524.0, // segment
                0.0, // line
                229.7, // curve
                843.3, // split
                105.2, // point
                0.0, // wide_point
                419.6, // projected_point
                161.7, // carried_point
                544.5, // bent_point
                39.0, // piece
                265.0, // pen_piece
                67.0, // bend
                0.0, // slight_bend
                131.5, // placed_corner
                211.5, // corner
                467.9, // chain
                7.3, // crossing
                40.6, // kept_chain
                237.6, // step
                59.1, // passed_band
                0.0, // passed_border
                430.4, // band
                298.3, // band_chain
                320.9, // straight_chain
                45.2, // border
                216.0, // region
                99.5, // edge_row
                3.8, // flat_pixel
                36.3, // chain_visit
                418.9, // layer
                0.0, // layer_row
                107.3, // layer_edge
                181.2, // bent_edge
                194.7, // sum_row
                150.7, // row_chain
                106.5, // sum_part
                12.9, // sum_pixel
                0.0, // edge_group
                118.8, // line_crossing
                61.9, // span
                16.7, // fill
                0.6, // filled_pixel
                23.0, // blended_pixel
                33.7, // faded_pixel
            }),
    },
    // cortex-m4
    {
        .code = 83236,
        .bare_code = 55568,
        .feature_code = {2672, 5072, 4480, 5796, 2164, 3888, 856, 552, 1580, 1516, 5004, 480},
        .fixed_ram = 4,
        .stack = 6024,
        .cycles = 1.80,
        .frame = 429,
        .area = 441,
        .work =
            std::to_array<double>({
                1588.6, // picture
                89.2, // timeline
                1025.5, // key
                512.1, // item
                544.1, // track
                1090.2, // placement
                276.1, // law
                1684.0, // bezier_law
                1597.4, // bone
                0.0, // object
                828.7, // stroke
                522.8, // segment
                0.0, // line
                229.9, // curve
                840.0, // split
                104.3, // point
                0.0, // wide_point
                420.4, // projected_point
                161.6, // carried_point
                544.7, // bent_point
                38.9, // piece
                264.7, // pen_piece
                57.0, // bend
                0.0, // slight_bend
                133.4, // placed_corner
                214.2, // corner
                472.8, // chain
                7.3, // crossing
                40.6, // kept_chain
                237.9, // step
                60.3, // passed_band
                0.0, // passed_border
                431.2, // band
                297.8, // band_chain
                319.2, // straight_chain
                45.3, // border
                215.5, // region
                99.5, // edge_row
                4.5, // flat_pixel
                36.2, // chain_visit
                421.6, // layer
                0.0, // layer_row
                106.6, // layer_edge
                193.0, // bent_edge
                197.2, // sum_row
                149.8, // row_chain
                106.5, // sum_part
                12.3, // sum_pixel
                0.0, // edge_group
                118.6, // line_crossing
                62.8, // span
                17.0, // fill
                0.6, // filled_pixel
                23.1, // blended_pixel
                32.7, // faded_pixel
            }),
    },
    // cortex-m7
    {
        .code = 83252,
        .bare_code = 55600,
        .feature_code = {2672, 5064, 4472, 5788, 2164, 3892, 848, 552, 1580, 1516, 4996, 480},
        .fixed_ram = 4,
        .stack = 6024,
        .cycles = 1.67,
        .frame = 424,
        .area = 455,
        .work =
            std::to_array<double>({
                1584.1, // picture
                89.2, // timeline
                1025.6, // key
                515.3, // item
                542.0, // track
                1080.5, // placement
                275.8, // law
                1672.4, // bezier_law
                1596.2, // bone
                0.0, // object
                838.6, // stroke
                523.3, // segment
                0.0, // line
                229.7, // curve
                839.3, // split
                105.2, // point
                0.0, // wide_point
                418.6, // projected_point
                161.0, // carried_point
                544.3, // bent_point
                39.0, // piece
                265.0, // pen_piece
                67.6, // bend
                0.0, // slight_bend
                131.5, // placed_corner
                211.5, // corner
                467.8, // chain
                7.3, // crossing
                40.6, // kept_chain
                238.9, // step
                60.0, // passed_band
                0.0, // passed_border
                430.6, // band
                299.2, // band_chain
                320.5, // straight_chain
                45.5, // border
                208.0, // region
                103.0, // edge_row
                3.2, // flat_pixel
                36.4, // chain_visit
                410.7, // layer
                0.0, // layer_row
                108.5, // layer_edge
                187.0, // bent_edge
                198.7, // sum_row
                150.9, // row_chain
                109.4, // sum_part
                14.7, // sum_pixel
                0.0, // edge_group
                117.1, // line_crossing
                56.7, // span
                17.5, // fill
                0.8, // filled_pixel
                24.0, // blended_pixel
                33.8, // faded_pixel
            }),
    },
    // cortex-m33
    {
        .code = 83212,
        .bare_code = 55556,
        .feature_code = {2664, 5072, 4488, 5804, 2168, 3900, 856, 552, 1584, 1528, 4988, 488},
        .fixed_ram = 4,
        .stack = 6032,
        .cycles = 1.79,
        .frame = 427,
        .area = 443,
        .work =
            std::to_array<double>({
                1585.8, // picture
                89.2, // timeline
                1025.8, // key
                513.8, // item
                543.3, // track
                1077.5, // placement
                276.1, // law
                1672.2, // bezier_law
                1594.7, // bone
                0.0, // object
                834.7, // stroke
                523.4, // segment
                0.0, // line
                229.7, // curve
                839.3, // split
                105.2, // point
                0.0, // wide_point
                419.6, // projected_point
                161.2, // carried_point
                544.0, // bent_point
                38.7, // piece
                264.5, // pen_piece
                66.3, // bend
                0.0, // slight_bend
                131.5, // placed_corner
                211.9, // corner
                467.9, // chain
                7.3, // crossing
                40.6, // kept_chain
                237.9, // step
                60.2, // passed_band
                0.0, // passed_border
                430.6, // band
                298.3, // band_chain
                320.9, // straight_chain
                45.3, // border
                215.8, // region
                99.6, // edge_row
                3.8, // flat_pixel
                36.4, // chain_visit
                419.2, // layer
                0.0, // layer_row
                107.4, // layer_edge
                181.1, // bent_edge
                194.5, // sum_row
                150.6, // row_chain
                106.6, // sum_part
                13.0, // sum_pixel
                0.0, // edge_group
                118.8, // line_crossing
                61.9, // span
                16.7, // fill
                0.6, // filled_pixel
                23.0, // blended_pixel
                33.7, // faded_pixel
            }),
    },
}};

}

const ProcessorCosts& costs_of(Processor processor) { return table[static_cast<std::size_t>(processor)]; }

}
