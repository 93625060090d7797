// Written by scripts/calibrate.

#include "host/fit/cost_table.hpp"
#include "host/fit/work_names.hpp"

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
static_assert(kinds == work_names, "the kinds of work have changed: scripts/calibrate");

constexpr std::array<ProcessorCosts, processor_count> table{{
    // cortex-m0
    {
        .code = 81364,
        .bare_code = 56880,
        .feature_code = {2448, 5208, 4748, 5788, 2240, 4028, 892, 608, 1552, 1504},
        .fixed_ram = 4,
        .stack = 7628,
        .cycles = 1.68,
        .frame = 871,
        .area = 534,
        .work =
            std::to_array<double>({
                2382.0, // picture
                118.5, // timeline
                1076.9, // key
                560.3, // item
                1052.4, // track
                734.1, // placement
                585.7, // law
                2970.3, // bezier_law
                1933.9, // bone
                0.0, // object
                1324.1, // stroke
                790.7, // segment
                0.0, // line
                210.9, // curve
                1056.4, // split
                147.0, // point
                0.0, // wide_point
                943.6, // projected_point
                216.0, // carried_point
                628.8, // bent_point
                63.0, // piece
                450.0, // pen_piece
                228.8, // bend
                0.0, // slight_bend
                194.7, // placed_corner
                265.6, // corner
                622.5, // chain
                7.2, // crossing
                53.1, // kept_chain
                300.7, // step
                84.8, // passed_band
                0.0, // passed_border
                551.9, // band
                328.9, // band_chain
                378.4, // straight_chain
                53.0, // border
                235.1, // region
                142.5, // edge_row
                9.4, // flat_pixel
                44.8, // chain_visit
                519.7, // layer
                0.0, // layer_row
                135.1, // layer_edge
                311.5, // bent_edge
                281.7, // sum_row
                180.1, // row_chain
                138.8, // sum_part
                15.8, // sum_pixel
                0.0, // edge_group
                152.2, // line_crossing
                78.0, // span
                24.5, // fill
                0.0, // filled_pixel
                33.6, // blended_pixel
                49.0, // faded_pixel
            }),
    },
    // cortex-m3
    {
        .code = 78444,
        .bare_code = 54656,
        .feature_code = {2556, 4936, 4640, 5604, 2160, 3708, 848, 544, 1560, 1536},
        .fixed_ram = 4,
        .stack = 7484,
        .cycles = 1.80,
        .frame = 426,
        .area = 412,
        .work =
            std::to_array<double>({
                1832.3, // picture
                91.6, // timeline
                1035.2, // key
                446.6, // item
                830.3, // track
                40.9, // placement
                235.3, // law
                1937.3, // bezier_law
                978.6, // bone
                0.0, // object
                840.1, // stroke
                525.1, // segment
                0.0, // line
                219.2, // curve
                887.1, // split
                109.3, // point
                0.0, // wide_point
                415.6, // projected_point
                203.6, // carried_point
                538.8, // bent_point
                41.4, // piece
                269.8, // pen_piece
                44.0, // bend
                0.0, // slight_bend
                126.4, // placed_corner
                208.7, // corner
                483.6, // chain
                7.2, // crossing
                40.6, // kept_chain
                226.3, // step
                59.0, // passed_band
                0.0, // passed_border
                436.1, // band
                285.0, // band_chain
                323.6, // straight_chain
                42.1, // border
                202.6, // region
                102.5, // edge_row
                2.5, // flat_pixel
                37.1, // chain_visit
                402.9, // layer
                0.0, // layer_row
                108.5, // layer_edge
                215.8, // bent_edge
                198.5, // sum_row
                149.3, // row_chain
                107.4, // sum_part
                12.3, // sum_pixel
                0.0, // edge_group
                119.8, // line_crossing
                63.9, // span
                19.6, // fill
                0.7, // filled_pixel
                23.5, // blended_pixel
                33.6, // faded_pixel
            }),
    },
    // cortex-m4
    {
        .code = 78480,
        .bare_code = 54700,
        .feature_code = {2560, 4912, 4632, 5580, 2160, 3704, 848, 544, 1564, 1532},
        .fixed_ram = 4,
        .stack = 7476,
        .cycles = 1.80,
        .frame = 427,
        .area = 410,
        .work =
            std::to_array<double>({
                1836.3, // picture
                91.6, // timeline
                1034.2, // key
                446.5, // item
                835.3, // track
                38.0, // placement
                235.2, // law
                1956.0, // bezier_law
                990.5, // bone
                0.0, // object
                837.3, // stroke
                524.1, // segment
                0.0, // line
                219.6, // curve
                883.4, // split
                108.4, // point
                0.0, // wide_point
                416.3, // projected_point
                202.8, // carried_point
                538.6, // bent_point
                42.2, // piece
                270.9, // pen_piece
                35.3, // bend
                0.0, // slight_bend
                128.1, // placed_corner
                210.4, // corner
                488.9, // chain
                7.3, // crossing
                40.6, // kept_chain
                226.5, // step
                60.1, // passed_band
                0.0, // passed_border
                436.6, // band
                284.6, // band_chain
                322.1, // straight_chain
                42.3, // border
                202.1, // region
                102.5, // edge_row
                3.2, // flat_pixel
                36.9, // chain_visit
                406.2, // layer
                0.0, // layer_row
                107.6, // layer_edge
                228.9, // bent_edge
                201.2, // sum_row
                148.4, // row_chain
                107.4, // sum_part
                11.6, // sum_pixel
                0.0, // edge_group
                119.6, // line_crossing
                64.8, // span
                20.0, // fill
                0.7, // filled_pixel
                23.6, // blended_pixel
                32.6, // faded_pixel
            }),
    },
    // cortex-m7
    {
        .code = 78516,
        .bare_code = 54748,
        .feature_code = {2568, 4916, 4624, 5576, 2160, 3692, 848, 544, 1560, 1528},
        .fixed_ram = 4,
        .stack = 7476,
        .cycles = 1.65,
        .frame = 423,
        .area = 424,
        .work =
            std::to_array<double>({
                1829.4, // picture
                91.7, // timeline
                1035.0, // key
                446.2, // item
                828.8, // track
                45.5, // placement
                235.1, // law
                1937.0, // bezier_law
                984.2, // bone
                0.0, // object
                841.2, // stroke
                524.3, // segment
                0.0, // line
                219.2, // curve
                883.3, // split
                109.3, // point
                0.0, // wide_point
                414.6, // projected_point
                202.7, // carried_point
                538.7, // bent_point
                41.4, // piece
                269.8, // pen_piece
                44.7, // bend
                0.0, // slight_bend
                126.4, // placed_corner
                208.7, // corner
                483.6, // chain
                7.2, // crossing
                40.6, // kept_chain
                227.9, // step
                59.8, // passed_band
                0.0, // passed_border
                436.3, // band
                285.9, // band_chain
                323.4, // straight_chain
                42.4, // border
                194.5, // region
                106.0, // edge_row
                1.8, // flat_pixel
                37.3, // chain_visit
                394.5, // layer
                0.0, // layer_row
                109.6, // layer_edge
                222.3, // bent_edge
                202.8, // sum_row
                149.5, // row_chain
                110.3, // sum_part
                14.1, // sum_pixel
                0.0, // edge_group
                118.1, // line_crossing
                58.6, // span
                20.5, // fill
                0.8, // filled_pixel
                24.5, // blended_pixel
                33.7, // faded_pixel
            }),
    },
    // cortex-m33
    {
        .code = 78464,
        .bare_code = 54688,
        .feature_code = {2560, 4920, 4636, 5588, 2168, 3704, 848, 544, 1560, 1536},
        .fixed_ram = 4,
        .stack = 7484,
        .cycles = 1.79,
        .frame = 426,
        .area = 412,
        .work =
            std::to_array<double>({
                1832.0, // picture
                91.6, // timeline
                1035.0, // key
                446.8, // item
                830.0, // track
                41.8, // placement
                235.3, // law
                1937.3, // bezier_law
                985.4, // bone
                0.0, // object
                839.2, // stroke
                524.5, // segment
                0.0, // line
                219.3, // curve
                883.2, // split
                109.3, // point
                0.0, // wide_point
                415.6, // projected_point
                202.7, // carried_point
                538.3, // bent_point
                41.4, // piece
                269.8, // pen_piece
                43.9, // bend
                0.0, // slight_bend
                126.4, // placed_corner
                208.7, // corner
                483.7, // chain
                7.2, // crossing
                40.6, // kept_chain
                226.6, // step
                60.0, // passed_band
                0.0, // passed_border
                436.3, // band
                285.0, // band_chain
                323.6, // straight_chain
                42.2, // border
                202.5, // region
                102.6, // edge_row
                2.5, // flat_pixel
                37.2, // chain_visit
                403.3, // layer
                0.0, // layer_row
                108.5, // layer_edge
                215.8, // bent_edge
                198.5, // sum_row
                149.3, // row_chain
                107.4, // sum_part
                12.3, // sum_pixel
                0.0, // edge_group
                119.8, // line_crossing
                63.8, // span
                19.6, // fill
                0.7, // filled_pixel
                23.5, // blended_pixel
                33.6, // faded_pixel
            }),
    },
}};

}

const ProcessorCosts& costs_of(Processor processor) { return table[static_cast<std::size_t>(processor)]; }

}
