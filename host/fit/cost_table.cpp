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
        .bare_code = 60440,
        .feature_code = {2528, 5336, 4688, 5956, 2224, 4172, 892, 624, 2332, 1508, 5928, 524},
        .fixed_ram = 4,
        .stack = 6680,
        .cycles = 1.68,
        .frame = 905,
        .area = 532,
        .work =
            std::to_array<double>({
                2041.1, // picture
                123.8, // timeline
                1135.9, // key
                617.3, // item
                841.1, // track
                1601.5, // placement
                625.7, // law
                2725.5, // bezier_law
                2235.3, // bone
                0.0, // object
                1457.2, // stroke
                756.1, // segment
                21.4, // line
                287.7, // curve
                1059.1, // split
                137.7, // point
                0.0, // wide_point
                933.1, // projected_point
                200.6, // carried_point
                614.5, // bent_point
                88.3, // piece
                463.7, // pen_piece
                209.8, // bend
                0.0, // slight_bend
                184.1, // placed_corner
                231.4, // corner
                682.5, // chain
                6.8, // crossing
                53.2, // kept_chain
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
        .stack = 6296,
        .cycles = 1.80,
        .frame = 441,
        .area = 413,
        .work =
            std::to_array<double>({
                1573.1, // picture
                97.8, // timeline
                1015.1, // key
                516.5, // item
                509.8, // track
                1278.0, // placement
                270.9, // law
                1685.8, // bezier_law
                1681.7, // bone
                0.0, // object
                1001.6, // stroke
                510.0, // segment
                0.0, // line
                275.4, // curve
                876.4, // split
                98.7, // point
                0.0, // wide_point
                409.0, // projected_point
                169.3, // carried_point
                533.0, // bent_point
                58.3, // piece
                307.2, // pen_piece
                60.3, // bend
                0.0, // slight_bend
                124.1, // placed_corner
                184.4, // corner
                511.6, // chain
                6.8, // crossing
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
        .stack = 6296,
        .cycles = 1.79,
        .frame = 442,
        .area = 411,
        .work =
            std::to_array<double>({
                1575.8, // picture
                97.7, // timeline
                1015.3, // key
                514.9, // item
                511.2, // track
                1288.2, // placement
                271.0, // law
                1699.0, // bezier_law
                1682.1, // bone
                0.0, // object
                991.5, // stroke
                508.9, // segment
                0.0, // line
                275.6, // curve
                873.0, // split
                97.9, // point
                0.0, // wide_point
                409.8, // projected_point
                169.5, // carried_point
                533.2, // bent_point
                58.0, // piece
                306.8, // pen_piece
                49.4, // bend
                0.0, // slight_bend
                125.9, // placed_corner
                187.3, // corner
                516.2, // chain
                6.9, // crossing
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
        .code = 88188,
        .bare_code = 58140,
        .feature_code = {2672, 5072, 4596, 5796, 2160, 3884, 848, 544, 2240, 1520, 5816, 480},
        .fixed_ram = 4,
        .stack = 6280,
        .cycles = 1.67,
        .frame = 438,
        .area = 424,
        .work =
            std::to_array<double>({
                1574.2, // picture
                97.8, // timeline
                1018.6, // key
                517.6, // item
                513.9, // track
                1275.7, // placement
                271.0, // law
                1679.8, // bezier_law
                1671.7, // bone
                0.0, // object
                963.4, // stroke
                507.6, // segment
                0.0, // line
                269.3, // curve
                875.4, // split
                99.3, // point
                0.0, // wide_point
                408.5, // projected_point
                170.0, // carried_point
                535.4, // bent_point
                52.1, // piece
                315.3, // pen_piece
                40.2, // bend
                0.0, // slight_bend
                124.6, // placed_corner
                191.9, // corner
                510.8, // chain
                6.7, // crossing
                40.8, // kept_chain
                267.5, // step
                57.3, // passed_band
                0.0, // passed_border
                399.8, // band
                314.4, // band_chain
                355.4, // straight_chain
                50.9, // border
                245.0, // region
                96.7, // edge_row
                2.0, // flat_pixel
                34.6, // chain_visit
                391.4, // layer
                0.0, // layer_row
                97.9, // layer_edge
                222.7, // bent_edge
                285.8, // sum_row
                154.9, // row_chain
                128.5, // sum_part
                11.5, // sum_pixel
                0.0, // edge_group
                114.4, // line_crossing
                45.3, // span
                4.0, // fill
                1.2, // filled_pixel
                23.7, // blended_pixel
                37.8, // faded_pixel
            }),
    },
    // cortex-m33
    {
        .code = 88172,
        .bare_code = 58144,
        .feature_code = {2664, 5080, 4612, 5812, 2172, 3900, 856, 552, 2244, 1524, 5808, 488},
        .fixed_ram = 4,
        .stack = 6296,
        .cycles = 1.80,
        .frame = 441,
        .area = 413,
        .work =
            std::to_array<double>({
                1572.9, // picture
                97.8, // timeline
                1015.2, // key
                516.6, // item
                510.0, // track
                1277.4, // placement
                270.9, // law
                1685.7, // bezier_law
                1680.0, // bone
                0.0, // object
                998.7, // stroke
                509.4, // segment
                0.0, // line
                275.3, // curve
                872.5, // split
                98.8, // point
                0.0, // wide_point
                409.0, // projected_point
                169.1, // carried_point
                532.6, // bent_point
                57.9, // piece
                306.6, // pen_piece
                59.6, // bend
                0.0, // slight_bend
                124.1, // placed_corner
                184.9, // corner
                511.5, // chain
                6.8, // crossing
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
