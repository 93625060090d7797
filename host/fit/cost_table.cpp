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
        .code = 86008,
        .bare_code = 57620,
        .feature_code = {2520, 5324, 4604, 5952, 2232, 4184, 884, 608, 1556, 1492, 5036, 516},
        .fixed_ram = 4,
        .stack = 5808,
        .cycles = 1.68,
        .frame = 888,
        .area = 564,
        .work =
            std::to_array<double>({
                2058.9, // picture
                117.0, // timeline
                1130.8, // key
                605.6, // item
                854.9, // track
                1403.0, // placement
                632.2, // law
                2668.1, // bezier_law
                2137.5, // bone
                0.0, // object
                1371.7, // stroke
                804.6, // segment
                0.0, // line
                226.9, // curve
                957.3, // split
                145.0, // point
                0.0, // wide_point
                956.4, // projected_point
                196.3, // carried_point
                622.3, // bent_point
                62.1, // piece
                445.9, // pen_piece
                249.7, // bend
                0.0, // slight_bend
                198.7, // placed_corner
                267.1, // corner
                611.4, // chain
                7.4, // crossing
                53.0, // kept_chain
                318.3, // step
                84.9, // passed_band
                0.0, // passed_border
                545.8, // band
                346.0, // band_chain
                374.6, // straight_chain
                56.9, // border
                254.1, // region
                137.6, // edge_row
                10.9, // flat_pixel
                44.3, // chain_visit
                540.0, // layer
                0.0, // layer_row
                135.1, // layer_edge
                266.6, // bent_edge
                282.1, // sum_row
                181.0, // row_chain
                136.9, // sum_part
                16.4, // sum_pixel
                0.0, // edge_group
                150.1, // line_crossing
                76.4, // span
                20.0, // fill
                0.0, // filled_pixel
                32.8, // blended_pixel
                49.1, // faded_pixel
            }),
    },
    // cortex-m3
    {
        .code = 83340,
        .bare_code = 55536,
        .feature_code = {2652, 5080, 4492, 5808, 2164, 3904, 848, 544, 1572, 1516, 5096, 480},
        .fixed_ram = 4,
        .stack = 5584,
        .cycles = 1.80,
        .frame = 427,
        .area = 442,
        .work =
            std::to_array<double>({
                1587.2, // picture
                89.3, // timeline
                1022.4, // key
                513.2, // item
                534.5, // track
                1099.5, // placement
                275.8, // law
                1675.4, // bezier_law
                1598.4, // bone
                0.0, // object
                851.7, // stroke
                531.3, // segment
                0.0, // line
                239.5, // curve
                830.5, // split
                104.1, // point
                0.0, // wide_point
                419.3, // projected_point
                159.7, // carried_point
                541.2, // bent_point
                46.8, // piece
                275.3, // pen_piece
                87.2, // bend
                0.0, // slight_bend
                131.0, // placed_corner
                202.6, // corner
                466.9, // chain
                7.6, // crossing
                40.6, // kept_chain
                237.7, // step
                59.1, // passed_band
                0.0, // passed_border
                431.7, // band
                297.6, // band_chain
                320.0, // straight_chain
                45.0, // border
                216.8, // region
                99.4, // edge_row
                3.7, // flat_pixel
                36.7, // chain_visit
                416.1, // layer
                0.0, // layer_row
                107.9, // layer_edge
                181.2, // bent_edge
                198.6, // sum_row
                150.1, // row_chain
                106.0, // sum_part
                12.9, // sum_pixel
                0.0, // edge_group
                118.2, // line_crossing
                62.5, // span
                16.7, // fill
                0.6, // filled_pixel
                23.0, // blended_pixel
                33.7, // faded_pixel
            }),
    },
    // cortex-m4
    {
        .code = 83356,
        .bare_code = 55568,
        .feature_code = {2672, 5072, 4480, 5796, 2164, 3888, 856, 552, 1580, 1516, 5124, 480},
        .fixed_ram = 4,
        .stack = 5576,
        .cycles = 1.80,
        .frame = 429,
        .area = 441,
        .work =
            std::to_array<double>({
                1589.6, // picture
                89.2, // timeline
                1021.8, // key
                511.7, // item
                534.8, // track
                1113.0, // placement
                275.7, // law
                1687.7, // bezier_law
                1600.3, // bone
                0.0, // object
                846.9, // stroke
                530.3, // segment
                0.0, // line
                240.3, // curve
                826.8, // split
                103.1, // point
                0.0, // wide_point
                420.0, // projected_point
                159.5, // carried_point
                541.0, // bent_point
                47.6, // piece
                276.5, // pen_piece
                79.3, // bend
                0.0, // slight_bend
                132.8, // placed_corner
                204.2, // corner
                471.8, // chain
                7.6, // crossing
                40.6, // kept_chain
                238.0, // step
                60.2, // passed_band
                0.0, // passed_border
                432.5, // band
                297.1, // band_chain
                318.3, // straight_chain
                45.1, // border
                216.3, // region
                99.4, // edge_row
                4.4, // flat_pixel
                36.5, // chain_visit
                418.9, // layer
                0.0, // layer_row
                107.1, // layer_edge
                193.0, // bent_edge
                201.1, // sum_row
                149.2, // row_chain
                106.0, // sum_part
                12.2, // sum_pixel
                0.0, // edge_group
                118.0, // line_crossing
                63.3, // span
                17.0, // fill
                0.6, // filled_pixel
                23.1, // blended_pixel
                32.7, // faded_pixel
            }),
    },
    // cortex-m7
    {
        .code = 83372,
        .bare_code = 55600,
        .feature_code = {2672, 5064, 4472, 5788, 2164, 3892, 848, 552, 1580, 1516, 5116, 480},
        .fixed_ram = 4,
        .stack = 5576,
        .cycles = 1.67,
        .frame = 424,
        .area = 455,
        .work =
            std::to_array<double>({
                1585.1, // picture
                89.3, // timeline
                1022.3, // key
                514.9, // item
                533.5, // track
                1101.9, // placement
                275.5, // law
                1675.6, // bezier_law
                1598.1, // bone
                0.0, // object
                852.0, // stroke
                530.6, // segment
                0.0, // line
                239.5, // curve
                826.5, // split
                104.1, // point
                0.0, // wide_point
                418.3, // projected_point
                159.1, // carried_point
                541.0, // bent_point
                46.8, // piece
                275.4, // pen_piece
                87.9, // bend
                0.0, // slight_bend
                131.1, // placed_corner
                202.6, // corner
                466.8, // chain
                7.6, // crossing
                40.6, // kept_chain
                239.0, // step
                60.0, // passed_band
                0.0, // passed_border
                431.9, // band
                298.5, // band_chain
                319.7, // straight_chain
                45.4, // border
                208.8, // region
                102.8, // edge_row
                3.1, // flat_pixel
                36.8, // chain_visit
                407.9, // layer
                0.0, // layer_row
                109.0, // layer_edge
                187.0, // bent_edge
                202.6, // sum_row
                150.3, // row_chain
                108.9, // sum_part
                14.7, // sum_pixel
                0.0, // edge_group
                116.5, // line_crossing
                57.2, // span
                17.5, // fill
                0.8, // filled_pixel
                24.0, // blended_pixel
                33.8, // faded_pixel
            }),
    },
    // cortex-m33
    {
        .code = 83332,
        .bare_code = 55556,
        .feature_code = {2664, 5072, 4488, 5804, 2168, 3900, 856, 552, 1584, 1528, 5108, 488},
        .fixed_ram = 4,
        .stack = 5584,
        .cycles = 1.79,
        .frame = 427,
        .area = 442,
        .work =
            std::to_array<double>({
                1586.8, // picture
                89.3, // timeline
                1022.3, // key
                513.4, // item
                534.5, // track
                1099.3, // placement
                275.8, // law
                1675.5, // bezier_law
                1597.1, // bone
                0.0, // object
                849.9, // stroke
                530.8, // segment
                0.0, // line
                239.6, // curve
                826.4, // split
                104.1, // point
                0.0, // wide_point
                419.3, // projected_point
                159.3, // carried_point
                540.6, // bent_point
                46.8, // piece
                275.3, // pen_piece
                87.2, // bend
                0.0, // slight_bend
                131.0, // placed_corner
                202.6, // corner
                466.9, // chain
                7.6, // crossing
                40.6, // kept_chain
                238.1, // step
                60.2, // passed_band
                0.0, // passed_border
                431.9, // band
                297.6, // band_chain
                320.0, // straight_chain
                45.1, // border
                216.6, // region
                99.4, // edge_row
                3.7, // flat_pixel
                36.7, // chain_visit
                416.5, // layer
                0.0, // layer_row
                107.9, // layer_edge
                181.1, // bent_edge
                198.4, // sum_row
                150.0, // row_chain
                106.0, // sum_part
                12.9, // sum_pixel
                0.0, // edge_group
                118.2, // line_crossing
                62.4, // span
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
