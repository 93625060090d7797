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
        .code = 90520,
        .bare_code = 60448,
        .feature_code = {2520, 5328, 4680, 5948, 2216, 4164, 884, 616, 2324, 1500, 5920, 516},
        .fixed_ram = 4,
        .stack = 6656,
        .cycles = 1.68,
        .frame = 905,
        .area = 525,
        .work =
            std::to_array<double>({
                2048.2, // picture
                125.1, // timeline
                1115.5, // key
                613.0, // item
                800.0, // track
                1845.0, // placement
                620.2, // law
                2711.9, // bezier_law
                2266.7, // bone
                0.0, // object
                1481.4, // stroke
                752.7, // segment
                2.0, // line
                272.9, // curve
                1069.6, // split
                131.3, // point
                0.0, // wide_point
                945.0, // projected_point
                197.5, // carried_point
                613.2, // bent_point
                90.7, // piece
                510.2, // pen_piece
                137.9, // bend
                0.0, // slight_bend
                179.9, // placed_corner
                229.3, // corner
                691.1, // chain
                7.1, // crossing
                53.2, // kept_chain
                354.5, // step
                81.5, // passed_band
                0.0, // passed_border
                507.2, // band
                364.2, // band_chain
                409.5, // straight_chain
                63.2, // border
                303.9, // region
                131.8, // edge_row
                9.6, // flat_pixel
                39.1, // chain_visit
                484.7, // layer
                0.0, // layer_row
                132.9, // layer_edge
                294.3, // bent_edge
                349.1, // sum_row
                191.4, // row_chain
                161.1, // sum_part
                13.4, // sum_pixel
                0.0, // edge_group
                149.0, // line_crossing
                61.0, // span
                4.3, // fill
                0.3, // filled_pixel
                32.7, // blended_pixel
                54.2, // faded_pixel
            }),
    },
    // cortex-m3
    {
        .code = 87384,
        .bare_code = 58080,
        .feature_code = {2648, 5088, 4608, 5812, 2160, 3896, 844, 544, 2232, 1520, 5792, 480},
        .fixed_ram = 4,
        .stack = 6320,
        .cycles = 1.80,
        .frame = 441,
        .area = 406,
        .work =
            std::to_array<double>({
                1575.7, // picture
                98.6, // timeline
                993.7, // key
                512.7, // item
                469.7, // track
                1492.1, // placement
                267.5, // law
                1658.9, // bezier_law
                1734.2, // bone
                0.0, // object
                1047.6, // stroke
                506.5, // segment
                0.0, // line
                266.8, // curve
                884.9, // split
                93.4, // point
                0.0, // wide_point
                410.8, // projected_point
                166.3, // carried_point
                528.3, // bent_point
                74.8, // piece
                334.8, // pen_piece
                17.0, // bend
                0.0, // slight_bend
                118.1, // placed_corner
                166.6, // corner
                528.0, // chain
                7.2, // crossing
                40.9, // kept_chain
                264.9, // step
                56.6, // passed_band
                0.0, // passed_border
                400.8, // band
                312.4, // band_chain
                350.1, // straight_chain
                50.4, // border
                258.9, // region
                95.4, // edge_row
                2.3, // flat_pixel
                32.5, // chain_visit
                372.0, // layer
                0.0, // layer_row
                106.5, // layer_edge
                204.9, // bent_edge
                258.1, // sum_row
                158.6, // row_chain
                127.1, // sum_part
                10.2, // sum_pixel
                0.0, // edge_group
                117.1, // line_crossing
                49.0, // span
                2.4, // fill
                1.0, // filled_pixel
                22.8, // blended_pixel
                37.8, // faded_pixel
            }),
    },
    // cortex-m4
    {
        .code = 87396,
        .bare_code = 58100,
        .feature_code = {2672, 5080, 4612, 5804, 2168, 3896, 856, 552, 2240, 1528, 5832, 480},
        .fixed_ram = 4,
        .stack = 6320,
        .cycles = 1.80,
        .frame = 442,
        .area = 404,
        .work =
            std::to_array<double>({
                1578.4, // picture
                98.5, // timeline
                994.1, // key
                511.1, // item
                471.3, // track
                1502.0, // placement
                267.7, // law
                1672.5, // bezier_law
                1734.0, // bone
                0.0, // object
                1037.2, // stroke
                505.3, // segment
                0.0, // line
                267.1, // curve
                881.6, // split
                92.6, // point
                0.0, // wide_point
                411.6, // projected_point
                166.5, // carried_point
                528.5, // bent_point
                74.6, // piece
                334.4, // pen_piece
                6.9, // bend
                0.0, // slight_bend
                119.9, // placed_corner
                169.4, // corner
                532.8, // chain
                7.2, // crossing
                40.8, // kept_chain
                265.9, // step
                57.6, // passed_band
                0.0, // passed_border
                401.5, // band
                311.8, // band_chain
                348.7, // straight_chain
                50.6, // border
                258.4, // region
                95.4, // edge_row
                3.0, // flat_pixel
                32.4, // chain_visit
                374.5, // layer
                0.0, // layer_row
                105.8, // layer_edge
                217.0, // bent_edge
                260.6, // sum_row
                157.7, // row_chain
                127.2, // sum_part
                9.5, // sum_pixel
                0.0, // edge_group
                116.9, // line_crossing
                49.8, // span
                2.8, // fill
                1.0, // filled_pixel
                22.8, // blended_pixel
                36.8, // faded_pixel
            }),
    },
    // cortex-m7
    {
        .code = 87412,
        .bare_code = 58140,
        .feature_code = {2672, 5072, 4596, 5796, 2160, 3884, 848, 544, 2240, 1520, 5816, 480},
        .fixed_ram = 4,
        .stack = 6320,
        .cycles = 1.67,
        .frame = 438,
        .area = 417,
        .work =
            std::to_array<double>({
                1573.8, // picture
                98.6, // timeline
                993.9, // key
                514.2, // item
                469.1, // track
                1493.4, // placement
                267.3, // law
                1659.7, // bezier_law
                1733.9, // bone
                0.0, // object
                1048.1, // stroke
                505.8, // segment
                0.0, // line
                266.8, // curve
                880.9, // split
                93.5, // point
                0.0, // wide_point
                409.8, // projected_point
                165.9, // carried_point
                528.1, // bent_point
                74.7, // piece
                334.7, // pen_piece
                17.6, // bend
                0.0, // slight_bend
                118.1, // placed_corner
                166.7, // corner
                527.9, // chain
                7.2, // crossing
                40.9, // kept_chain
                266.6, // step
                57.4, // passed_band
                0.0, // passed_border
                401.4, // band
                313.0, // band_chain
                349.8, // straight_chain
                50.7, // border
                250.9, // region
                98.8, // edge_row
                1.7, // flat_pixel
                32.7, // chain_visit
                364.1, // layer
                0.0, // layer_row
                107.5, // layer_edge
                211.8, // bent_edge
                262.3, // sum_row
                158.8, // row_chain
                129.9, // sum_part
                12.0, // sum_pixel
                0.0, // edge_group
                115.4, // line_crossing
                43.8, // span
                3.2, // fill
                1.2, // filled_pixel
                23.7, // blended_pixel
                37.9, // faded_pixel
            }),
    },
    // cortex-m33
    {
        .code = 87412,
        .bare_code = 58144,
        .feature_code = {2664, 5080, 4612, 5812, 2172, 3900, 856, 552, 2244, 1524, 5808, 488},
        .fixed_ram = 4,
        .stack = 6320,
        .cycles = 1.80,
        .frame = 441,
        .area = 406,
        .work =
            std::to_array<double>({
                1575.5, // picture
                98.6, // timeline
                993.9, // key
                512.8, // item
                470.0, // track
                1491.4, // placement
                267.5, // law
                1658.7, // bezier_law
                1732.4, // bone
                0.0, // object
                1044.5, // stroke
                505.8, // segment
                0.0, // line
                266.7, // curve
                881.0, // split
                93.5, // point
                0.0, // wide_point
                410.8, // projected_point
                166.1, // carried_point
                527.8, // bent_point
                74.4, // piece
                334.1, // pen_piece
                16.3, // bend
                0.0, // slight_bend
                118.2, // placed_corner
                167.1, // corner
                527.9, // chain
                7.2, // crossing
                40.9, // kept_chain
                265.7, // step
                57.6, // passed_band
                0.0, // passed_border
                400.9, // band
                312.4, // band_chain
                350.1, // straight_chain
                50.5, // border
                258.8, // region
                95.4, // edge_row
                2.3, // flat_pixel
                32.6, // chain_visit
                372.3, // layer
                0.0, // layer_row
                106.5, // layer_edge
                204.8, // bent_edge
                258.0, // sum_row
                158.5, // row_chain
                127.1, // sum_part
                10.2, // sum_pixel
                0.0, // edge_group
                117.0, // line_crossing
                49.0, // span
                2.4, // fill
                1.0, // filled_pixel
                22.8, // blended_pixel
                37.8, // faded_pixel
            }),
    },
}};

}

const ProcessorCosts& costs_of(Processor processor) { return table[static_cast<std::size_t>(processor)]; }

}
