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
        .code = 76932,
        .fixed_ram = 4,
        .stack = 9000,
        .cycles = 1.68,
        .frame = 791,
        .area = 416,
        .work =
            std::to_array<double>({
                0.0, // picture
                300.0, // timeline
                416.1, // key
                4249.6, // item
                2440.8, // track
                2609.0, // placement
                143.9, // law
                3322.0, // bezier_law
                4273.7, // bone
                781.8, // object
                2839.7, // stroke
                827.3, // segment
                42.6, // line
                234.5, // curve
                1207.2, // split
                126.8, // point
                0.0, // wide_point
                1042.4, // projected_point
                129.0, // carried_point
                577.2, // bent_point
                74.4, // piece
                511.4, // pen_piece
                250.6, // bend
                0.0, // slight_bend
                260.7, // placed_corner
                234.3, // corner
                492.0, // chain
                9.7, // crossing
                89.2, // kept_chain
                329.6, // step
                76.3, // passed_band
                0.0, // passed_border
                609.3, // band
                294.8, // band_chain
                351.3, // straight_chain
                86.6, // border
                190.7, // region
                186.0, // edge_row
                4.8, // flat_pixel
                48.5, // chain_visit
                663.5, // layer
                0.0, // layer_row
                106.2, // layer_edge
                260.3, // bent_edge
                350.1, // sum_row
                176.3, // row_chain
                139.9, // sum_part
                12.7, // sum_pixel
                0.0, // edge_group
                149.0, // line_crossing
                77.1, // span
                30.8, // fill
                0.0, // filled_pixel
                40.8, // blended_pixel
                46.7, // faded_pixel
            }),
    },
    // cortex-m3
    {
        .code = 73384,
        .fixed_ram = 4,
        .stack = 8960,
        .cycles = 1.80,
        .frame = 403,
        .area = 337,
        .work =
            std::to_array<double>({
                0.0, // picture
                300.0, // timeline
                299.0, // key
                3117.2, // item
                1594.3, // track
                890.1, // placement
                0.0, // law
                2062.3, // bezier_law
                2704.3, // bone
                630.3, // object
                1347.0, // stroke
                539.2, // segment
                0.0, // line
                245.5, // curve
                1055.0, // split
                91.3, // point
                0.0, // wide_point
                264.5, // projected_point
                138.4, // carried_point
                522.4, // bent_point
                18.2, // piece
                304.5, // pen_piece
                36.1, // bend
                0.0, // slight_bend
                167.2, // placed_corner
                207.7, // corner
                398.7, // chain
                8.9, // crossing
                50.4, // kept_chain
                243.9, // step
                53.3, // passed_band
                0.0, // passed_border
                452.3, // band
                254.4, // band_chain
                299.1, // straight_chain
                72.4, // border
                179.9, // region
                134.2, // edge_row
                0.0, // flat_pixel
                41.5, // chain_visit
                511.9, // layer
                0.0, // layer_row
                85.3, // layer_edge
                178.9, // bent_edge
                247.0, // sum_row
                145.0, // row_chain
                109.9, // sum_part
                10.2, // sum_pixel
                0.0, // edge_group
                115.8, // line_crossing
                63.1, // span
                22.9, // fill
                0.3, // filled_pixel
                29.8, // blended_pixel
                32.1, // faded_pixel
            }),
    },
    // cortex-m4
    {
        .code = 73396,
        .fixed_ram = 4,
        .stack = 8952,
        .cycles = 1.80,
        .frame = 402,
        .area = 334,
        .work =
            std::to_array<double>({
                0.0, // picture
                300.0, // timeline
                300.5, // key
                3121.0, // item
                1597.1, // track
                887.5, // placement
                0.0, // law
                2068.4, // bezier_law
                2697.8, // bone
                619.6, // object
                1356.4, // stroke
                537.7, // segment
                0.0, // line
                245.3, // curve
                1051.2, // split
                90.3, // point
                0.0, // wide_point
                266.3, // projected_point
                138.1, // carried_point
                522.3, // bent_point
                18.7, // piece
                305.9, // pen_piece
                34.1, // bend
                0.0, // slight_bend
                169.9, // placed_corner
                209.7, // corner
                399.3, // chain
                9.0, // crossing
                50.5, // kept_chain
                244.4, // step
                54.3, // passed_band
                0.0, // passed_border
                457.0, // band
                253.7, // band_chain
                297.3, // straight_chain
                72.4, // border
                177.6, // region
                135.2, // edge_row
                0.2, // flat_pixel
                41.4, // chain_visit
                514.6, // layer
                0.0, // layer_row
                84.8, // layer_edge
                190.6, // bent_edge
                250.5, // sum_row
                144.0, // row_chain
                109.7, // sum_part
                9.4, // sum_pixel
                0.0, // edge_group
                115.6, // line_crossing
                64.5, // span
                23.4, // fill
                0.3, // filled_pixel
                29.9, // blended_pixel
                31.1, // faded_pixel
            }),
    },
    // cortex-m7
    {
        .code = 73456,
        .fixed_ram = 4,
        .stack = 8952,
        .cycles = 1.66,
        .frame = 400,
        .area = 342,
        .work =
            std::to_array<double>({
                0.0, // picture
                300.0, // timeline
                299.6, // key
                3115.4, // item
                1595.5, // track
                887.4, // placement
                0.0, // law
                2062.1, // bezier_law
                2704.3, // bone
                628.7, // object
                1346.7, // stroke
                538.2, // segment
                0.0, // line
                245.6, // curve
                1050.8, // split
                91.3, // point
                0.0, // wide_point
                265.5, // projected_point
                137.7, // carried_point
                523.1, // bent_point
                18.6, // piece
                303.1, // pen_piece
                35.2, // bend
                0.0, // slight_bend
                167.2, // placed_corner
                208.1, // corner
                398.7, // chain
                8.9, // crossing
                50.5, // kept_chain
                245.0, // step
                54.2, // passed_band
                0.0, // passed_border
                461.0, // band
                255.6, // band_chain
                300.0, // straight_chain
                72.7, // border
                174.1, // region
                137.6, // edge_row
                0.0, // flat_pixel
                41.7, // chain_visit
                504.2, // layer
                0.0, // layer_row
                85.5, // layer_edge
                186.1, // bent_edge
                251.2, // sum_row
                145.1, // row_chain
                113.0, // sum_part
                12.3, // sum_pixel
                0.0, // edge_group
                113.9, // line_crossing
                57.0, // span
                23.6, // fill
                0.4, // filled_pixel
                31.1, // blended_pixel
                32.2, // faded_pixel
            }),
    },
}};

}

const ProcessorCosts& costs_of(Processor processor) { return table[static_cast<std::size_t>(processor)]; }

}
