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
        .code = 72240,
        .fixed_ram = 4,
        .stack = 8896,
        .cycles = 1.70,
        .frame = 790,
        .area = 745,
        .work =
            std::to_array<double>({
                0.0, // picture
                2368.3, // item
                3509.2, // track
                838.6, // key
                0.0, // placement
                1672.2, // law
                4004.9, // bezier_law
                0.0, // bone
                1570.3, // object
                6779.9, // stroke
                0.0, // line
                1101.0, // curve
                691.7, // split
                40.7, // point
                0.0, // wide_point
                1032.7, // projected_point
                409.0, // carried_point
                971.3, // bent_point
                215.7, // piece
                189.1, // wide_piece
                480.4, // pen_piece
                188.3, // bend
                0.0, // slight_bend
                267.3, // placed_corner
                208.3, // corner
                590.1, // chain
                11.5, // crossing
                239.1, // kept_chain
                634.3, // step
                487.3, // band
                274.8, // band_chain
                375.0, // straight_chain
                159.0, // border
                144.4, // region
                199.7, // edge_row
                1.9, // flat_pixel
                52.9, // chain_visit
                737.6, // layer
                0.0, // layer_row
                169.6, // layer_edge
                0.0, // sum_row
                203.5, // row_chain
                132.3, // sum_part
                1.8, // sum_pixel
                394.9, // edge_group
                191.7, // line_crossing
                111.0, // span
                8.5, // fill
                2.7, // filled_pixel
                39.7, // blended_pixel
                49.8, // faded_pixel
            }),
    },
    // cortex-m3
    {
        .code = 68348,
        .fixed_ram = 4,
        .stack = 8776,
        .cycles = 1.82,
        .frame = 403,
        .area = 594,
        .work =
            std::to_array<double>({
                0.0, // picture
                2178.6, // item
                1870.5, // track
                347.5, // key
                0.0, // placement
                836.0, // law
                2573.5, // bezier_law
                0.0, // bone
                735.1, // object
                3598.8, // stroke
                0.0, // line
                1053.0, // curve
                450.3, // split
                20.2, // point
                0.0, // wide_point
                253.1, // projected_point
                318.1, // carried_point
                586.6, // bent_point
                113.7, // piece
                52.7, // wide_piece
                256.8, // pen_piece
                14.0, // bend
                0.0, // slight_bend
                162.9, // placed_corner
                205.3, // corner
                444.6, // chain
                11.4, // crossing
                129.3, // kept_chain
                461.4, // step
                291.2, // band
                233.7, // band_chain
                322.7, // straight_chain
                128.4, // border
                174.3, // region
                155.4, // edge_row
                0.0, // flat_pixel
                47.0, // chain_visit
                568.8, // layer
                0.0, // layer_row
                130.2, // layer_edge
                0.0, // sum_row
                168.8, // row_chain
                97.9, // sum_part
                0.0, // sum_pixel
                235.7, // edge_group
                163.2, // line_crossing
                94.5, // span
                0.8, // fill
                2.2, // filled_pixel
                27.7, // blended_pixel
                34.9, // faded_pixel
            }),
    },
    // cortex-m4
    {
        .code = 68388,
        .fixed_ram = 4,
        .stack = 8776,
        .cycles = 1.82,
        .frame = 402,
        .area = 592,
        .work =
            std::to_array<double>({
                0.0, // picture
                2181.0, // item
                1871.9, // track
                348.8, // key
                0.0, // placement
                838.1, // law
                2575.7, // bezier_law
                0.0, // bone
                718.5, // object
                3610.5, // stroke
                0.0, // line
                1049.8, // curve
                448.9, // split
                19.3, // point
                0.0, // wide_point
                254.9, // projected_point
                317.1, // carried_point
                586.8, // bent_point
                115.2, // piece
                54.1, // wide_piece
                258.8, // pen_piece
                13.8, // bend
                0.0, // slight_bend
                165.3, // placed_corner
                206.5, // corner
                445.5, // chain
                11.4, // crossing
                129.8, // kept_chain
                465.1, // step
                293.0, // band
                232.2, // band_chain
                323.0, // straight_chain
                128.8, // border
                177.6, // region
                157.1, // edge_row
                0.0, // flat_pixel
                47.0, // chain_visit
                577.9, // layer
                0.0, // layer_row
                131.1, // layer_edge
                0.0, // sum_row
                168.5, // row_chain
                95.2, // sum_part
                0.0, // sum_pixel
                243.3, // edge_group
                163.9, // line_crossing
                95.9, // span
                0.0, // fill
                2.2, // filled_pixel
                27.0, // blended_pixel
                33.9, // faded_pixel
            }),
    },
    // cortex-m7
    {
        .code = 68408,
        .fixed_ram = 4,
        .stack = 8768,
        .cycles = 1.69,
        .frame = 400,
        .area = 589,
        .work =
            std::to_array<double>({
                0.0, // picture
                2177.6, // item
                1871.4, // track
                347.6, // key
                0.0, // placement
                834.1, // law
                2574.8, // bezier_law
                0.0, // bone
                729.8, // object
                3597.8, // stroke
                0.0, // line
                1051.4, // curve
                448.4, // split
                20.3, // point
                0.0, // wide_point
                254.1, // projected_point
                317.5, // carried_point
                585.6, // bent_point
                113.9, // piece
                53.0, // wide_piece
                257.0, // pen_piece
                14.7, // bend
                0.0, // slight_bend
                162.9, // placed_corner
                205.1, // corner
                444.7, // chain
                11.4, // crossing
                129.4, // kept_chain
                464.8, // step
                297.8, // band
                234.1, // band_chain
                321.6, // straight_chain
                129.4, // border
                175.4, // region
                153.6, // edge_row
                0.0, // flat_pixel
                47.1, // chain_visit
                569.4, // layer
                0.0, // layer_row
                129.7, // layer_edge
                0.0, // sum_row
                168.7, // row_chain
                98.9, // sum_part
                0.0, // sum_pixel
                231.4, // edge_group
                162.7, // line_crossing
                95.0, // span
                1.1, // fill
                2.1, // filled_pixel
                27.8, // blended_pixel
                34.9, // faded_pixel
            }),
    },
}};

}

const ProcessorCosts& costs_of(Processor processor) { return table[static_cast<std::size_t>(processor)]; }

}
