// Written by scripts/calibrate.

#include "host/fit/cost_table.hpp"
#include "host/fit/op_counts.hpp"

#include <array>
#include <string_view>

namespace kfast::fit {
namespace {

// What the costs below are of.
constexpr auto kinds = std::to_array<std::string_view>({
    "picture", "timeline", "key", "item", "track", "placement", "law", "bezier_law", "bone", "object",
    "stroke", "segment", "line", "curve", "split", "point", "wide_point", "projected_point",
    "carried_point", "bent_point", "piece", "pen_piece", "bend", "slight_bend", "placed_corner", "corner",
    "chain", "crossing", "kept_chain", "step", "passed_band", "passed_border", "band", "band_chain",
    "straight_chain", "border", "region", "edge_row", "flat_pixel", "chain_visit", "layer", "layer_row",
    "layer_edge", "bent_edge", "sum_row", "row_chain", "sum_part", "sum_pixel", "edge_group",
    "line_crossing", "span", "fill", "filled_pixel", "blended_pixel", "faded_pixel",
});
static_assert(kinds == op_names, "the kinds of work have changed: scripts/calibrate");

constexpr std::array<ProcessorCosts, processor_count> table{{
    // cortex-m0
    {
        .code = 91200,
        .bare_code = 61000,
        .feature_code = {1968, 4776, 4128, 5396, 1664, 3612, 332, 64, 1772, 948, 5368, 0},
        .fixed_ram = 4,
        .stack = 6664,
        .cycles = 1.68,
        .frame = 905,
        .area = 532,
        .work =
            std::to_array<double>({
                2048.4, // picture
                123.6, // timeline
                1140.0, // key
                615.3, // item
                852.2, // track
                1580.8, // placement
                627.2, // law
                2733.7, // bezier_law
                2214.7, // bone
                0.0, // object
                1433.2, // stroke
                757.8, // segment
                0.0, // line
                275.2, // curve
                1057.5, // split
                138.4, // point
                0.0, // wide_point
                934.3, // projected_point
                198.9, // carried_point
                618.1, // bent_point
                73.0, // piece
                481.4, // pen_piece
                174.5, // bend
                0.0, // slight_bend
                185.4, // placed_corner
                248.5, // corner
                680.3, // chain
                6.6, // crossing
                53.1, // kept_chain
                355.5, // step
                81.4, // passed_band
                0.0, // passed_border
                505.3, // band
                365.9, // band_chain
                415.9, // straight_chain
                63.4, // border
                297.1, // region
                129.3, // edge_row
                9.8, // flat_pixel
                41.4, // chain_visit
                516.6, // layer
                0.0, // layer_row
                121.5, // layer_edge
                306.9, // bent_edge
                377.6, // sum_row
                186.8, // row_chain
                159.3, // sum_part
                12.8, // sum_pixel
                0.0, // edge_group
                147.8, // line_crossing
                62.9, // span
                5.1, // fill
                0.3, // filled_pixel
                32.8, // blended_pixel
                54.1, // faded_pixel
            }),
    },
    // cortex-m3
    {
        .code = 88144,
        .bare_code = 58080,
        .feature_code = {2648, 5088, 4608, 5812, 2160, 3896, 844, 544, 2232, 1520, 5792, 480},
        .fixed_ram = 4,
        .stack = 6280,
        .cycles = 1.80,
        .frame = 441,
        .area = 413,
        .work =
            std::to_array<double>({
                1575.8, // picture
                97.8, // timeline
                1018.1, // key
                516.0, // item
                514.3, // track
                1274.2, // placement
                271.2, // law
                1680.0, // bezier_law
                1673.1, // bone
                0.0, // object
                967.7, // stroke
                508.5, // segment
                0.0, // line
                269.6, // curve
                879.1, // split
                99.1, // point
                0.0, // wide_point
                409.4, // projected_point
                170.4, // carried_point
                535.3, // bent_point
                52.9, // piece
                314.5, // pen_piece
                41.6, // bend
                0.0, // slight_bend
                124.5, // placed_corner
                191.0, // corner
                511.1, // chain
                6.7, // crossing
                40.8, // kept_chain
                265.7, // step
                56.4, // passed_band
                0.0, // passed_border
                399.3, // band
                313.7, // band_chain
                355.5, // straight_chain
                50.6, // border
                253.1, // region
                93.3, // edge_row
                2.5, // flat_pixel
                34.5, // chain_visit
                399.0, // layer
                0.0, // layer_row
                96.9, // layer_edge
                215.8, // bent_edge
                281.5, // sum_row
                154.6, // row_chain
                125.7, // sum_part
                9.7, // sum_pixel
                0.0, // edge_group
                116.1, // line_crossing
                50.6, // span
                3.2, // fill
                1.1, // filled_pixel
                22.8, // blended_pixel
                37.7, // faded_pixel
            }),
    },
    // cortex-m4
    {
        .code = 88148,
        .bare_code = 58100,
        .feature_code = {2672, 5080, 4612, 5804, 2168, 3896, 856, 552, 2240, 1528, 5832, 480},
        .fixed_ram = 4,
        .stack = 6280,
        .cycles = 1.79,
        .frame = 442,
        .area = 411,
        .work =
            std::to_array<double>({
                1578.5, // picture
                97.7, // timeline
                1018.4, // key
                514.5, // item
                515.8, // track
                1284.4, // placement
                271.3, // law
                1693.1, // bezier_law
                1673.6, // bone
                0.0, // object
                957.7, // stroke
                507.3, // segment
                0.0, // line
                269.8, // curve
                875.8, // split
                98.3, // point
                0.0, // wide_point
                410.3, // projected_point
                170.5, // carried_point
                535.5, // bent_point
                52.6, // piece
                314.0, // pen_piece
                30.7, // bend
                0.0, // slight_bend
                126.4, // placed_corner
                194.0, // corner
                515.7, // chain
                6.7, // crossing
                40.8, // kept_chain
                266.7, // step
                57.5, // passed_band
                0.0, // passed_border
                399.9, // band
                313.1, // band_chain
                354.2, // straight_chain
                50.7, // border
                252.6, // region
                93.2, // edge_row
                3.2, // flat_pixel
                34.4, // chain_visit
                401.5, // layer
                0.0, // layer_row
                96.2, // layer_edge
                228.0, // bent_edge
                284.0, // sum_row
                153.7, // row_chain
                125.8, // sum_part
                9.0, // sum_pixel
                0.0, // edge_group
                115.9, // line_crossing
                51.4, // span
                3.5, // fill
                1.0, // filled_pixel
                22.8, // blended_pixel
                36.7, // faded_pixel
            }),
    },
    // cortex-m7
    {
        .code = 87412,
        .bare_code = 58140,
        .feature_code = {2672, 5072, 4596, 5796, 2160, 3884, 848, 544, 2240, 1520, 5816, 480},
        .fixed_ram = 4,
        .stack = 5736,
        .cycles = 1.67,
        .frame = 436,
        .area = 435,
        .work =
            std::to_array<double>({
                1838.7, // picture
                99.5, // timeline
                1040.7, // key
                354.6, // item
                1055.0, // track
                66.0, // placement
                260.4, // law
                1643.3, // bezier_law
                1649.2, // bone
                236.1, // object
                413.6, // stroke
                485.6, // segment
                221.4, // line
                408.7, // curve
                726.0, // split
                46.1, // point
                0.0, // wide_point
                395.9, // projected_point
                0.0, // carried_point
                0.0, // bent_point
                242.5, // piece
                507.1, // pen_piece
                286.8, // bend
                0.0, // slight_bend
                133.4, // placed_corner
                0.0, // corner
                563.2, // chain
                7.1, // crossing
                40.2, // kept_chain
                212.0, // step
                67.2, // passed_band
                0.0, // passed_border
                407.7, // band
                301.2, // band_chain
                296.2, // straight_chain
                48.1, // border
                174.6, // region
                131.7, // edge_row
                0.0, // flat_pixel
                38.1, // chain_visit
                481.9, // layer
                0.0, // layer_row
                101.5, // layer_edge
                87.1, // bent_edge
                228.9, // sum_row
                166.7, // row_chain
                124.4, // sum_part
                13.2, // sum_pixel
                0.0, // edge_group
                98.5, // line_crossing
                45.1, // span
                20.8, // fill
                0.5, // filled_pixel
                29.3, // blended_pixel
                34.1, // faded_pixel
            }),
    },
    // cortex-m33
    {
        .code = 88188,
        .bare_code = 58144,
        .feature_code = {2664, 5080, 4612, 5812, 2172, 3900, 856, 552, 2244, 1524, 5808, 488},
        .fixed_ram = 4,
        .stack = 6280,
        .cycles = 1.80,
        .frame = 441,
        .area = 413,
        .work =
            std::to_array<double>({
                1575.6, // picture
                97.8, // timeline
                1018.3, // key
                516.2, // item
                514.6, // track
                1273.5, // placement
                271.2, // law
                1680.0, // bezier_law
                1671.4, // bone
                0.0, // object
                964.8, // stroke
                507.8, // segment
                0.0, // line
                269.5, // curve
                875.3, // split
                99.2, // point
                0.0, // wide_point
                409.5, // projected_point
                170.1, // carried_point
                534.9, // bent_point
                52.5, // piece
                313.9, // pen_piece
                40.9, // bend
                0.0, // slight_bend
                124.6, // placed_corner
                191.5, // corner
                511.0, // chain
                6.7, // crossing
                40.8, // kept_chain
                266.5, // step
                57.4, // passed_band
                0.0, // passed_border
                399.3, // band
                313.7, // band_chain
                355.5, // straight_chain
                50.7, // border
                253.0, // region
                93.3, // edge_row
                2.5, // flat_pixel
                34.6, // chain_visit
                399.3, // layer
                0.0, // layer_row
                96.9, // layer_edge
                215.7, // bent_edge
                281.4, // sum_row
                154.5, // row_chain
                125.7, // sum_part
                9.7, // sum_pixel
                0.0, // edge_group
                116.1, // line_crossing
                50.6, // span
                3.2, // fill
                1.1, // filled_pixel
                22.8, // blended_pixel
                37.7, // faded_pixel
            }),
    },
}};

}

const ProcessorCosts& costs_of(Processor processor) { return table[static_cast<std::size_t>(processor)]; }

}
