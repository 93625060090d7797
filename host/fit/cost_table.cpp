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
        .code = 80400,
        .bare_code = 56000,
        .feature_code = {2448, 5200, 4708, 5952, 2092, 3956, 872, 600, 1524, 1500},
        .fixed_ram = 4,
        .stack = 7580,
        .cycles = 1.68,
        .frame = 830,
        .area = 534,
        .work =
            std::to_array<double>({
                2459.6, // picture
                184.5, // timeline
                946.9, // key
                539.6, // item
                1010.8, // track
                854.0, // placement
                559.9, // law
                3447.4, // bezier_law
                2272.9, // bone
                0.0, // object
                1323.4, // stroke
                801.1, // segment
                0.0, // line
                225.3, // curve
                1038.2, // split
                147.3, // point
                0.0, // wide_point
                1107.9, // projected_point
                197.2, // carried_point
                635.8, // bent_point
                61.1, // piece
                453.8, // pen_piece
                232.3, // bend
                0.0, // slight_bend
                201.3, // placed_corner
                267.0, // corner
                613.2, // chain
                7.0, // crossing
                53.2, // kept_chain
                300.7, // step
                84.8, // passed_band
                0.0, // passed_border
                551.9, // band
                328.9, // band_chain
                378.4, // straight_chain
                53.0, // border
                235.0, // region
                142.5, // edge_row
                9.3, // flat_pixel
                44.8, // chain_visit
                519.6, // layer
                0.0, // layer_row
                135.2, // layer_edge
                311.6, // bent_edge
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
        .code = 77016,
        .bare_code = 53356,
        .feature_code = {2548, 4928, 4604, 5680, 2032, 3692, 836, 536, 1536, 1528},
        .fixed_ram = 4,
        .stack = 7444,
        .cycles = 1.79,
        .frame = 426,
        .area = 412,
        .work =
            std::to_array<double>({
                1794.3, // picture
                112.1, // timeline
                1013.0, // key
                450.9, // item
                802.4, // track
                108.1, // placement
                245.3, // law
                2159.5, // bezier_law
                1090.3, // bone
                0.0, // object
                857.0, // stroke
                528.9, // segment
                0.0, // line
                224.0, // curve
                881.9, // split
                108.5, // point
                0.0, // wide_point
                413.8, // projected_point
                195.2, // carried_point
                537.1, // bent_point
                41.5, // piece
                272.4, // pen_piece
                47.3, // bend
                0.0, // slight_bend
                128.7, // placed_corner
                208.1, // corner
                479.6, // chain
                7.2, // crossing
                40.7, // kept_chain
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
                108.6, // layer_edge
                215.9, // bent_edge
                198.4, // sum_row
                149.4, // row_chain
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
        .code = 77008,
        .bare_code = 53368,
        .feature_code = {2560, 4912, 4596, 5656, 2020, 3704, 836, 536, 1544, 1536},
        .fixed_ram = 4,
        .stack = 7436,
        .cycles = 1.80,
        .frame = 428,
        .area = 410,
        .work =
            std::to_array<double>({
                1798.4, // picture
                112.1, // timeline
                1012.1, // key
                450.8, // item
                807.4, // track
                105.6, // placement
                245.2, // law
                2178.3, // bezier_law
                1102.3, // bone
                0.0, // object
                854.0, // stroke
                528.0, // segment
                0.0, // line
                224.4, // curve
                878.2, // split
                107.6, // point
                0.0, // wide_point
                415.5, // projected_point
                194.4, // carried_point
                537.2, // bent_point
                42.3, // piece
                273.5, // pen_piece
                38.5, // bend
                0.0, // slight_bend
                130.4, // placed_corner
                209.8, // corner
                484.9, // chain
                7.2, // crossing
                40.7, // kept_chain
                226.5, // step
                60.1, // passed_band
                0.0, // passed_border
                436.6, // band
                284.6, // band_chain
                322.0, // straight_chain
                42.3, // border
                202.1, // region
                102.5, // edge_row
                3.1, // flat_pixel
                36.9, // chain_visit
                406.2, // layer
                0.0, // layer_row
                107.7, // layer_edge
                229.0, // bent_edge
                201.1, // sum_row
                148.5, // row_chain
                107.3, // sum_part
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
        .code = 77060,
        .bare_code = 53412,
        .feature_code = {2568, 4908, 4600, 5660, 2040, 3692, 836, 536, 1544, 1536},
        .fixed_ram = 4,
        .stack = 7436,
        .cycles = 1.66,
        .frame = 423,
        .area = 424,
        .work =
            std::to_array<double>({
                1791.5, // picture
                112.2, // timeline
                1012.8, // key
                450.5, // item
                800.7, // track
                113.1, // placement
                245.0, // law
                2159.7, // bezier_law
                1095.9, // bone
                0.0, // object
                858.0, // stroke
                528.1, // segment
                0.0, // line
                224.1, // curve
                878.1, // split
                108.5, // point
                0.0, // wide_point
                415.8, // projected_point
                194.3, // carried_point
                537.7, // bent_point
                41.5, // piece
                272.5, // pen_piece
                48.0, // bend
                0.0, // slight_bend
                128.8, // placed_corner
                208.1, // corner
                479.6, // chain
                7.2, // crossing
                40.7, // kept_chain
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
                109.7, // layer_edge
                222.4, // bent_edge
                202.7, // sum_row
                149.6, // row_chain
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
        .code = 77072,
        .bare_code = 53428,
        .feature_code = {2552, 4916, 4608, 5668, 2036, 3692, 836, 536, 1540, 1524},
        .fixed_ram = 4,
        .stack = 7444,
        .cycles = 1.79,
        .frame = 428,
        .area = 412,
        .work =
            std::to_array<double>({
                1795.0, // picture
                112.1, // timeline
                1012.4, // key
                450.9, // item
                802.2, // track
                109.3, // placement
                245.3, // law
                2159.7, // bezier_law
                1098.2, // bone
                0.0, // object
                855.9, // stroke
                528.3, // segment
                0.0, // line
                224.2, // curve
                877.9, // split
                108.5, // point
                0.0, // wide_point
                414.5, // projected_point
                194.2, // carried_point
                537.2, // bent_point
                41.4, // piece
                272.4, // pen_piece
                47.2, // bend
                0.0, // slight_bend
                128.7, // placed_corner
                208.2, // corner
                479.7, // chain
                7.2, // crossing
                40.7, // kept_chain
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
                37.1, // chain_visit
                403.3, // layer
                0.0, // layer_row
                108.6, // layer_edge
                215.9, // bent_edge
                198.4, // sum_row
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
