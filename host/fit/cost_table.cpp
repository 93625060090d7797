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
    "item",
    "track",
    "key",
    "placement",
    "law",
    "bezier_law",
    "bone",
    "object",
    "stroke",
    "line",
    "curve",
    "split",
    "point",
    "wide_point",
    "projected_point",
    "carried_point",
    "bent_point",
    "piece",
    "wide_piece",
    "pen_piece",
    "bend",
    "slight_bend",
    "placed_corner",
    "corner",
    "chain",
    "crossing",
    "kept_chain",
    "step",
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
        .code = 68628,
        .fixed_ram = 4,
        .stack = 8792,
        .cycles = 1.69,
        .frame = 791,
        .area = 739,
        .work =
            std::to_array<double>({
                0.0, // picture
                3875.1, // item
                2842.8, // track
                1112.4, // key
                0.0, // placement
                2094.7, // law
                3428.5, // bezier_law
                0.0, // bone
                1457.0, // object
                3128.6, // stroke
                0.0, // line
                1386.1, // curve
                676.8, // split
                49.3, // point
                0.0, // wide_point
                1081.5, // projected_point
                469.2, // carried_point
                1087.8, // bent_point
                48.9, // piece
                67.5, // wide_piece
                308.6, // pen_piece
                140.3, // bend
                0.0, // slight_bend
                60.0, // placed_corner
                347.2, // corner
                523.8, // chain
                11.0, // crossing
                177.5, // kept_chain
                638.5, // step
                328.8, // band
                254.7, // band_chain
                365.4, // straight_chain
                189.3, // border
                213.6, // region
                196.6, // edge_row
                9.3, // flat_pixel
                56.0, // chain_visit
                792.1, // layer
                0.0, // layer_row
                153.7, // layer_edge
                9.8, // sum_row
                190.4, // row_chain
                121.2, // sum_part
                3.6, // sum_pixel
                251.4, // edge_group
                126.8, // line_crossing
                104.7, // span
                0.0, // fill
                1.8, // filled_pixel
                39.8, // blended_pixel
                49.3, // faded_pixel
            }),
    },
    // cortex-m3
    {
        .code = 64940,
        .fixed_ram = 4,
        .stack = 8656,
        .cycles = 1.81,
        .frame = 403,
        .area = 569,
        .work =
            std::to_array<double>({
                0.0, // picture
                2748.6, // item
                1468.2, // track
                460.2, // key
                0.0, // placement
                1038.9, // law
                2227.3, // bezier_law
                0.0, // bone
                1129.0, // object
                1552.5, // stroke
                0.0, // line
                1151.0, // curve
                472.0, // split
                35.3, // point
                0.0, // wide_point
                282.9, // projected_point
                356.3, // carried_point
                657.0, // bent_point
                38.3, // piece
                0.4, // wide_piece
                181.4, // pen_piece
                0.0, // bend
                0.0, // slight_bend
                60.0, // placed_corner
                265.7, // corner
                423.0, // chain
                11.0, // crossing
                67.7, // kept_chain
                458.8, // step
                210.0, // band
                209.4, // band_chain
                316.8, // straight_chain
                147.2, // border
                206.6, // region
                154.9, // edge_row
                0.0, // flat_pixel
                47.8, // chain_visit
                597.4, // layer
                0.0, // layer_row
                125.1, // layer_edge
                3.1, // sum_row
                163.5, // row_chain
                78.6, // sum_part
                0.6, // sum_pixel
                143.3, // edge_group
                101.7, // line_crossing
                95.4, // span
                0.0, // fill
                1.8, // filled_pixel
                28.1, // blended_pixel
                34.3, // faded_pixel
            }),
    },
    // cortex-m4
    {
        .code = 65004,
        .fixed_ram = 4,
        .stack = 8664,
        .cycles = 1.81,
        .frame = 402,
        .area = 572,
        .work =
            std::to_array<double>({
                0.0, // picture
                2766.5, // item
                1469.4, // track
                461.4, // key
                0.0, // placement
                1038.6, // law
                2224.9, // bezier_law
                0.0, // bone
                1103.8, // object
                1553.4, // stroke
                0.0, // line
                1149.5, // curve
                470.0, // split
                34.6, // point
                0.0, // wide_point
                284.9, // projected_point
                356.0, // carried_point
                657.5, // bent_point
                39.9, // piece
                2.0, // wide_piece
                182.9, // pen_piece
                0.0, // bend
                0.0, // slight_bend
                60.0, // placed_corner
                266.8, // corner
                426.0, // chain
                11.1, // crossing
                67.5, // kept_chain
                459.5, // step
                203.8, // band
                210.1, // band_chain
                318.6, // straight_chain
                145.3, // border
                206.7, // region
                155.3, // edge_row
                0.0, // flat_pixel
                48.1, // chain_visit
                600.7, // layer
                0.0, // layer_row
                126.2, // layer_edge
                2.2, // sum_row
                163.0, // row_chain
                77.3, // sum_part
                0.2, // sum_pixel
                149.5, // edge_group
                102.0, // line_crossing
                96.9, // span
                0.0, // fill
                1.8, // filled_pixel
                27.7, // blended_pixel
                33.4, // faded_pixel
            }),
    },
    // cortex-m7
    {
        .code = 65024,
        .fixed_ram = 4,
        .stack = 8656,
        .cycles = 1.68,
        .frame = 400,
        .area = 568,
        .work =
            std::to_array<double>({
                0.0, // picture
                2747.8, // item
                1469.5, // track
                460.5, // key
                0.0, // placement
                1037.0, // law
                2228.2, // bezier_law
                0.0, // bone
                1124.1, // object
                1550.2, // stroke
                0.0, // line
                1149.5, // curve
                470.0, // split
                35.4, // point
                0.0, // wide_point
                283.9, // projected_point
                355.7, // carried_point
                656.0, // bent_point
                38.5, // piece
                0.5, // wide_piece
                181.6, // pen_piece
                0.0, // bend
                0.0, // slight_bend
                60.0, // placed_corner
                265.6, // corner
                423.2, // chain
                11.0, // crossing
                67.7, // kept_chain
                459.3, // step
                210.3, // band
                211.7, // band_chain
                317.5, // straight_chain
                146.0, // border
                209.1, // region
                153.2, // edge_row
                0.0, // flat_pixel
                48.0, // chain_visit
                597.2, // layer
                0.0, // layer_row
                124.8, // layer_edge
                3.3, // sum_row
                163.3, // row_chain
                79.9, // sum_part
                0.7, // sum_pixel
                138.9, // edge_group
                101.2, // line_crossing
                95.6, // span
                0.0, // fill
                1.7, // filled_pixel
                28.2, // blended_pixel
                34.4, // faded_pixel
            }),
    },
}};

}

const ProcessorCosts& costs_of(Processor processor) { return table[static_cast<std::size_t>(processor)]; }

}
