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
        .code = 72548,
        .fixed_ram = 4,
        .stack = 9128,
        .cycles = 1.72,
        .frame = 791,
        .area = 821,
        .work =
            std::to_array<double>({
                0.0, // picture
                2369.6, // item
                3536.1, // track
                817.2, // key
                0.0, // placement
                1640.5, // law
                3900.8, // bezier_law
                0.0, // bone
                1710.0, // object
                7047.8, // stroke
                0.0, // line
                1104.3, // curve
                690.3, // split
                39.7, // point
                0.0, // wide_point
                1041.1, // projected_point
                405.3, // carried_point
                964.0, // bent_point
                206.9, // piece
                182.4, // wide_piece
                478.5, // pen_piece
                371.7, // bend
                0.0, // slight_bend
                274.2, // placed_corner
                199.0, // corner
                485.3, // chain
                11.7, // crossing
                200.2, // kept_chain
                326.5, // step
                76.6, // passed_band
                0.0, // passed_border
                226.1, // band
                331.7, // band_chain
                572.6, // straight_chain
                88.3, // border
                263.5, // region
                145.1, // edge_row
                0.0, // flat_pixel
                65.4, // chain_visit
                502.5, // layer
                0.0, // layer_row
                162.0, // layer_edge
                247.8, // bent_edge
                293.8, // sum_row
                192.0, // row_chain
                115.6, // sum_part
                9.9, // sum_pixel
                209.5, // edge_group
                160.0, // line_crossing
                76.8, // span
                0.8, // fill
                0.2, // filled_pixel
                40.5, // blended_pixel
                49.5, // faded_pixel
            }),
    },
    // cortex-m3
    {
        .code = 69004,
        .fixed_ram = 4,
        .stack = 8976,
        .cycles = 1.83,
        .frame = 403,
        .area = 710,
        .work =
            std::to_array<double>({
                0.0, // picture
                2105.5, // item
                1919.1, // track
                326.3, // key
                0.0, // placement
                815.9, // law
                2472.1, // bezier_law
                0.0, // bone
                867.3, // object
                3769.5, // stroke
                0.0, // line
                1045.7, // curve
                450.8, // split
                22.3, // point
                0.0, // wide_point
                260.4, // projected_point
                316.6, // carried_point
                582.4, // bent_point
                110.4, // piece
                49.3, // wide_piece
                254.9, // pen_piece
                94.6, // bend
                0.0, // slight_bend
                163.4, // placed_corner
                198.9, // corner
                403.6, // chain
                11.6, // crossing
                109.6, // kept_chain
                242.4, // step
                53.6, // passed_band
                0.0, // passed_border
                83.7, // band
                291.7, // band_chain
                452.0, // straight_chain
                77.2, // border
                240.3, // region
                92.5, // edge_row
                0.0, // flat_pixel
                55.9, // chain_visit
                376.3, // layer
                0.0, // layer_row
                129.6, // layer_edge
                141.5, // bent_edge
                140.4, // sum_row
                158.9, // row_chain
                104.0, // sum_part
                7.2, // sum_pixel
                101.0, // edge_group
                131.4, // line_crossing
                62.4, // span
                0.0, // fill
                0.2, // filled_pixel
                30.5, // blended_pixel
                34.3, // faded_pixel
            }),
    },
    // cortex-m4
    {
        .code = 69028,
        .fixed_ram = 4,
        .stack = 8976,
        .cycles = 1.83,
        .frame = 402,
        .area = 706,
        .work =
            std::to_array<double>({
                0.0, // picture
                2108.3, // item
                1920.0, // track
                328.0, // key
                0.0, // placement
                817.7, // law
                2472.2, // bezier_law
                0.0, // bone
                849.5, // object
                3782.2, // stroke
                0.0, // line
                1042.6, // curve
                449.4, // split
                21.3, // point
                0.0, // wide_point
                262.3, // projected_point
                315.6, // carried_point
                582.6, // bent_point
                112.0, // piece
                50.7, // wide_piece
                256.9, // pen_piece
                94.9, // bend
                0.0, // slight_bend
                166.1, // placed_corner
                200.2, // corner
                403.9, // chain
                11.7, // crossing
                109.8, // kept_chain
                243.0, // step
                54.6, // passed_band
                0.0, // passed_border
                86.4, // band
                290.1, // band_chain
                448.9, // straight_chain
                77.7, // border
                239.0, // region
                94.2, // edge_row
                0.0, // flat_pixel
                56.3, // chain_visit
                379.6, // layer
                0.0, // layer_row
                130.5, // layer_edge
                153.5, // bent_edge
                146.1, // sum_row
                158.1, // row_chain
                103.4, // sum_part
                6.3, // sum_pixel
                102.9, // edge_group
                131.5, // line_crossing
                64.6, // span
                0.0, // fill
                0.3, // filled_pixel
                30.5, // blended_pixel
                33.3, // faded_pixel
            }),
    },
    // cortex-m7
    {
        .code = 69056,
        .fixed_ram = 4,
        .stack = 8968,
        .cycles = 1.69,
        .frame = 400,
        .area = 714,
        .work =
            std::to_array<double>({
                0.0, // picture
                2104.6, // item
                1919.9, // track
                326.4, // key
                0.0, // placement
                814.0, // law
                2473.3, // bezier_law
                0.0, // bone
                861.7, // object
                3768.3, // stroke
                0.0, // line
                1044.1, // curve
                448.8, // split
                22.4, // point
                0.0, // wide_point
                261.5, // projected_point
                316.0, // carried_point
                581.4, // bent_point
                110.7, // piece
                49.6, // wide_piece
                255.1, // pen_piece
                95.3, // bend
                0.0, // slight_bend
                163.4, // placed_corner
                198.7, // corner
                403.7, // chain
                11.6, // crossing
                109.7, // kept_chain
                243.5, // step
                54.5, // passed_band
                0.0, // passed_border
                91.1, // band
                293.2, // band_chain
                453.0, // straight_chain
                78.0, // border
                237.4, // region
                95.9, // edge_row
                0.0, // flat_pixel
                55.9, // chain_visit
                368.5, // layer
                0.0, // layer_row
                129.9, // layer_edge
                149.2, // bent_edge
                146.6, // sum_row
                160.1, // row_chain
                107.2, // sum_part
                9.8, // sum_pixel
                86.5, // edge_group
                130.9, // line_crossing
                54.9, // span
                0.0, // fill
                0.3, // filled_pixel
                31.3, // blended_pixel
                34.4, // faded_pixel
            }),
    },
}};

}

const ProcessorCosts& costs_of(Processor processor) { return table[static_cast<std::size_t>(processor)]; }

}
