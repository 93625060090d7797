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
        .code = 68636,
        .fixed_ram = 4,
        .stack = 8792,
        .cycles = 1.69,
        .frame = 791,
        .area = 739,
        .work =
            std::to_array<double>({
                0.0, // picture
                4957.4, // item
                2708.9, // track
                1101.3, // key
                0.0, // placement
                2055.0, // law
                3200.8, // bezier_law
                0.0, // bone
                0.0, // object
                3863.2, // stroke
                0.0, // line
                1479.1, // curve
                622.8, // split
                47.7, // point
                0.0, // wide_point
                1093.3, // projected_point
                449.0, // carried_point
                1077.7, // bent_point
                42.3, // piece
                95.2, // wide_piece
                337.2, // pen_piece
                153.0, // bend
                0.0, // slight_bend
                317.4, // corner
                539.0, // chain
                12.4, // crossing
                100.0, // kept_chain
                638.5, // step
                344.3, // band
                261.5, // band_chain
                372.6, // straight_chain
                189.2, // border
                213.8, // region
                196.8, // edge_row
                9.3, // flat_pixel
                56.0, // chain_visit
                792.5, // layer
                0.0, // layer_row
                153.9, // layer_edge
                9.4, // sum_row
                190.3, // row_chain
                120.9, // sum_part
                3.5, // sum_pixel
                252.3, // edge_group
                126.8, // line_crossing
                104.9, // span
                0.0, // fill
                1.8, // filled_pixel
                39.8, // blended_pixel
                49.2, // faded_pixel
            }),
    },
    // cortex-m3
    {
        .code = 64948,
        .fixed_ram = 4,
        .stack = 8656,
        .cycles = 1.81,
        .frame = 403,
        .area = 569,
        .work =
            std::to_array<double>({
                0.0, // picture
                3185.4, // item
                1409.7, // track
                457.9, // key
                0.0, // placement
                1024.5, // law
                2157.4, // bezier_law
                0.0, // bone
                519.6, // object
                1852.2, // stroke
                0.0, // line
                1193.9, // curve
                448.8, // split
                34.0, // point
                0.0, // wide_point
                286.6, // projected_point
                348.0, // carried_point
                652.4, // bent_point
                35.4, // piece
                11.6, // wide_piece
                193.5, // pen_piece
                0.0, // bend
                0.0, // slight_bend
                253.8, // corner
                431.6, // chain
                11.5, // crossing
                100.0, // kept_chain
                458.8, // step
                220.4, // band
                212.2, // band_chain
                319.7, // straight_chain
                147.1, // border
                206.7, // region
                154.8, // edge_row
                0.0, // flat_pixel
                47.8, // chain_visit
                597.2, // layer
                0.0, // layer_row
                125.1, // layer_edge
                2.9, // sum_row
                163.5, // row_chain
                78.5, // sum_part
                0.7, // sum_pixel
                143.3, // edge_group
                101.8, // line_crossing
                95.5, // span
                0.0, // fill
                1.8, // filled_pixel
                28.1, // blended_pixel
                34.3, // faded_pixel
            }),
    },
    // cortex-m4
    {
        .code = 65012,
        .fixed_ram = 4,
        .stack = 8664,
        .cycles = 1.81,
        .frame = 402,
        .area = 572,
        .work =
            std::to_array<double>({
                0.0, // picture
                3202.0, // item
                1411.1, // track
                459.1, // key
                0.0, // placement
                1024.2, // law
                2155.3, // bezier_law
                0.0, // bone
                496.2, // object
                1852.1, // stroke
                0.0, // line
                1192.1, // curve
                446.9, // split
                33.3, // point
                0.0, // wide_point
                288.5, // projected_point
                347.6, // carried_point
                652.9, // bent_point
                37.1, // piece
                13.2, // wide_piece
                195.0, // pen_piece
                0.0, // bend
                0.0, // slight_bend
                254.9, // corner
                434.6, // chain
                11.6, // crossing
                100.0, // kept_chain
                459.5, // step
                214.2, // band
                212.9, // band_chain
                321.5, // straight_chain
                145.2, // border
                206.8, // region
                155.3, // edge_row
                0.0, // flat_pixel
                48.1, // chain_visit
                600.5, // layer
                0.0, // layer_row
                126.3, // layer_edge
                2.0, // sum_row
                163.0, // row_chain
                77.2, // sum_part
                0.2, // sum_pixel
                149.4, // edge_group
                102.1, // line_crossing
                97.0, // span
                0.0, // fill
                1.8, // filled_pixel
                27.7, // blended_pixel
                33.4, // faded_pixel
            }),
    },
    // cortex-m7
    {
        .code = 65032,
        .fixed_ram = 4,
        .stack = 8656,
        .cycles = 1.68,
        .frame = 400,
        .area = 568,
        .work =
            std::to_array<double>({
                0.0, // picture
                3184.9, // item
                1410.9, // track
                458.2, // key
                0.0, // placement
                1022.6, // law
                2158.3, // bezier_law
                0.0, // bone
                514.3, // object
                1850.1, // stroke
                0.0, // line
                1192.3, // curve
                446.8, // split
                34.1, // point
                0.0, // wide_point
                287.6, // projected_point
                347.3, // carried_point
                651.4, // bent_point
                35.6, // piece
                11.8, // wide_piece
                193.7, // pen_piece
                0.0, // bend
                0.0, // slight_bend
                253.7, // corner
                431.8, // chain
                11.5, // crossing
                100.0, // kept_chain
                459.3, // step
                220.6, // band
                214.5, // band_chain
                320.4, // straight_chain
                145.9, // border
                209.2, // region
                153.2, // edge_row
                0.0, // flat_pixel
                48.0, // chain_visit
                597.0, // layer
                0.0, // layer_row
                124.9, // layer_edge
                3.1, // sum_row
                163.3, // row_chain
                79.8, // sum_part
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
