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
        .code = 72404,
        .fixed_ram = 4,
        .stack = 8984,
        .cycles = 1.72,
        .frame = 791,
        .area = 766,
        .work =
            std::to_array<double>({
                0.0, // picture
                2402.4, // item
                3506.0, // track
                820.0, // key
                79.5, // placement
                1617.9, // law
                3856.2, // bezier_law
                0.0, // bone
                1673.9, // object
                7044.8, // stroke
                0.0, // line
                1102.8, // curve
                687.7, // split
                41.3, // point
                0.0, // wide_point
                1042.2, // projected_point
                402.6, // carried_point
                964.9, // bent_point
                206.0, // piece
                182.4, // wide_piece
                475.6, // pen_piece
                361.6, // bend
                0.0, // slight_bend
                272.5, // placed_corner
                198.1, // corner
                500.5, // chain
                12.2, // crossing
                199.8, // kept_chain
                329.4, // step
                76.1, // passed_band
                0.0, // passed_border
                253.1, // band
                343.6, // band_chain
                437.0, // straight_chain
                98.0, // border
                279.6, // region
                147.6, // edge_row
                0.0, // flat_pixel
                65.1, // chain_visit
                501.1, // layer
                0.0, // layer_row
                147.7, // layer_edge
                280.2, // bent_edge
                147.0, // sum_row
                172.0, // row_chain
                127.3, // sum_part
                11.2, // sum_pixel
                69.4, // edge_group
                159.9, // line_crossing
                77.2, // span
                0.0, // fill
                0.0, // filled_pixel
                41.8, // blended_pixel
                49.7, // faded_pixel
            }),
    },
    // cortex-m3
    {
        .code = 68852,
        .fixed_ram = 4,
        .stack = 8832,
        .cycles = 1.83,
        .frame = 403,
        .area = 668,
        .work =
            std::to_array<double>({
                0.0, // picture
                2123.0, // item
                1911.9, // track
                331.8, // key
                0.0, // placement
                803.7, // law
                2468.4, // bezier_law
                0.0, // bone
                846.5, // object
                3766.4, // stroke
                0.0, // line
                1046.3, // curve
                447.7, // split
                23.4, // point
                0.0, // wide_point
                261.2, // projected_point
                314.3, // carried_point
                582.2, // bent_point
                108.7, // piece
                48.9, // wide_piece
                251.8, // pen_piece
                88.1, // bend
                0.0, // slight_bend
                162.9, // placed_corner
                199.0, // corner
                415.8, // chain
                11.7, // crossing
                110.5, // kept_chain
                244.3, // step
                53.3, // passed_band
                0.0, // passed_border
                106.7, // band
                295.5, // band_chain
                310.2, // straight_chain
                84.8, // border
                250.3, // region
                94.5, // edge_row
                0.0, // flat_pixel
                55.9, // chain_visit
                369.6, // layer
                0.0, // layer_row
                117.2, // layer_edge
                168.7, // bent_edge
                29.0, // sum_row
                143.4, // row_chain
                114.2, // sum_part
                8.4, // sum_pixel
                0.0, // edge_group
                131.0, // line_crossing
                62.8, // span
                0.0, // fill
                0.0, // filled_pixel
                31.6, // blended_pixel
                34.4, // faded_pixel
            }),
    },
    // cortex-m4
    {
        .code = 68876,
        .fixed_ram = 4,
        .stack = 8832,
        .cycles = 1.83,
        .frame = 402,
        .area = 664,
        .work =
            std::to_array<double>({
                0.0, // picture
                2126.2, // item
                1912.7, // track
                333.5, // key
                0.0, // placement
                805.4, // law
                2469.3, // bezier_law
                0.0, // bone
                828.7, // object
                3778.8, // stroke
                0.0, // line
                1043.3, // curve
                446.2, // split
                22.4, // point
                0.0, // wide_point
                263.1, // projected_point
                313.2, // carried_point
                582.4, // bent_point
                110.2, // piece
                50.3, // wide_piece
                253.7, // pen_piece
                88.3, // bend
                0.0, // slight_bend
                165.5, // placed_corner
                200.3, // corner
                416.4, // chain
                11.8, // crossing
                110.7, // kept_chain
                244.8, // step
                54.3, // passed_band
                0.0, // passed_border
                109.8, // band
                294.0, // band_chain
                307.2, // straight_chain
                85.3, // border
                249.4, // region
                96.0, // edge_row
                0.0, // flat_pixel
                56.4, // chain_visit
                373.3, // layer
                0.0, // layer_row
                117.8, // layer_edge
                180.7, // bent_edge
                32.9, // sum_row
                141.6, // row_chain
                113.7, // sum_part
                7.6, // sum_pixel
                1.1, // edge_group
                131.2, // line_crossing
                64.8, // span
                0.0, // fill
                0.0, // filled_pixel
                31.6, // blended_pixel
                33.4, // faded_pixel
            }),
    },
    // cortex-m7
    {
        .code = 68904,
        .fixed_ram = 4,
        .stack = 8824,
        .cycles = 1.69,
        .frame = 400,
        .area = 674,
        .work =
            std::to_array<double>({
                0.0, // picture
                2122.2, // item
                1912.7, // track
                332.0, // key
                0.0, // placement
                801.7, // law
                2469.6, // bezier_law
                0.0, // bone
                840.9, // object
                3765.2, // stroke
                0.0, // line
                1044.7, // curve
                445.7, // split
                23.5, // point
                0.0, // wide_point
                262.2, // projected_point
                313.7, // carried_point
                581.2, // bent_point
                108.9, // piece
                49.2, // wide_piece
                252.0, // pen_piece
                88.8, // bend
                0.0, // slight_bend
                162.9, // placed_corner
                198.8, // corner
                415.9, // chain
                11.7, // crossing
                110.6, // kept_chain
                245.3, // step
                54.1, // passed_band
                0.0, // passed_border
                112.7, // band
                297.1, // band_chain
                310.8, // straight_chain
                85.6, // border
                247.7, // region
                97.6, // edge_row
                0.0, // flat_pixel
                56.2, // chain_visit
                362.5, // layer
                0.0, // layer_row
                117.2, // layer_edge
                177.3, // bent_edge
                32.4, // sum_row
                143.4, // row_chain
                117.6, // sum_part
                10.9, // sum_pixel
                0.0, // edge_group
                130.3, // line_crossing
                55.3, // span
                0.0, // fill
                0.0, // filled_pixel
                32.5, // blended_pixel
                34.5, // faded_pixel
            }),
    },
}};

}

const ProcessorCosts& costs_of(Processor processor) { return table[static_cast<std::size_t>(processor)]; }

}
