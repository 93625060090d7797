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
        .code = 72732,
        .fixed_ram = 4,
        .stack = 9016,
        .cycles = 1.70,
        .frame = 791,
        .area = 412,
        .work =
            std::to_array<double>({
                0.0, // picture
                2403.1, // item
                3506.0, // track
                819.0, // key
                81.0, // placement
                1616.3, // law
                3865.3, // bezier_law
                0.0, // bone
                1685.7, // object
                7041.9, // stroke
                300.0, // segment
                0.0, // line
                1103.8, // curve
                687.1, // split
                41.3, // point
                0.0, // wide_point
                1042.2, // projected_point
                402.7, // carried_point
                965.0, // bent_point
                205.4, // piece
                475.0, // pen_piece
                362.0, // bend
                0.0, // slight_bend
                272.6, // placed_corner
                198.6, // corner
                501.5, // chain
                12.0, // crossing
                200.0, // kept_chain
                328.5, // step
                76.2, // passed_band
                0.0, // passed_border
                598.3, // band
                293.9, // band_chain
                351.0, // straight_chain
                87.5, // border
                196.9, // region
                183.6, // edge_row
                5.9, // flat_pixel
                48.8, // chain_visit
                669.7, // layer
                0.0, // layer_row
                105.0, // layer_edge
                255.2, // bent_edge
                341.1, // sum_row
                177.6, // row_chain
                141.9, // sum_part
                13.1, // sum_pixel
                0.0, // edge_group
                148.6, // line_crossing
                76.2, // span
                29.9, // fill
                0.0, // filled_pixel
                40.6, // blended_pixel
                46.8, // faded_pixel
            }),
    },
    // cortex-m3
    {
        .code = 69188,
        .fixed_ram = 4,
        .stack = 8864,
        .cycles = 1.81,
        .frame = 403,
        .area = 332,
        .work =
            std::to_array<double>({
                0.0, // picture
                2125.5, // item
                1910.8, // track
                331.2, // key
                0.0, // placement
                802.4, // law
                2483.4, // bezier_law
                0.0, // bone
                857.4, // object
                3764.3, // stroke
                300.0, // segment
                0.0, // line
                1047.9, // curve
                446.8, // split
                23.4, // point
                0.0, // wide_point
                261.4, // projected_point
                314.2, // carried_point
                582.2, // bent_point
                107.6, // piece
                250.8, // pen_piece
                89.7, // bend
                0.0, // slight_bend
                163.1, // placed_corner
                199.6, // corner
                417.3, // chain
                11.5, // crossing
                111.0, // kept_chain
                243.8, // step
                53.3, // passed_band
                0.0, // passed_border
                445.9, // band
                253.4, // band_chain
                298.3, // straight_chain
                73.0, // border
                184.8, // region
                132.7, // edge_row
                0.6, // flat_pixel
                41.8, // chain_visit
                518.4, // layer
                0.0, // layer_row
                84.3, // layer_edge
                170.4, // bent_edge
                242.0, // sum_row
                146.0, // row_chain
                112.2, // sum_part
                10.3, // sum_pixel
                0.0, // edge_group
                115.0, // line_crossing
                62.8, // span
                21.8, // fill
                0.4, // filled_pixel
                29.7, // blended_pixel
                32.1, // faded_pixel
            }),
    },
    // cortex-m4
    {
        .code = 69204,
        .fixed_ram = 4,
        .stack = 8864,
        .cycles = 1.81,
        .frame = 402,
        .area = 329,
        .work =
            std::to_array<double>({
                0.0, // picture
                2128.4, // item
                1911.7, // track
                332.8, // key
                0.0, // placement
                804.2, // law
                2484.4, // bezier_law
                0.0, // bone
                839.6, // object
                3776.7, // stroke
                300.0, // segment
                0.0, // line
                1044.8, // curve
                445.3, // split
                22.4, // point
                0.0, // wide_point
                263.3, // projected_point
                313.2, // carried_point
                582.3, // bent_point
                109.1, // piece
                252.8, // pen_piece
                89.8, // bend
                0.0, // slight_bend
                165.8, // placed_corner
                201.0, // corner
                417.9, // chain
                11.6, // crossing
                111.2, // kept_chain
                244.3, // step
                54.3, // passed_band
                0.0, // passed_border
                449.5, // band
                252.9, // band_chain
                296.5, // straight_chain
                73.2, // border
                183.3, // region
                133.0, // edge_row
                1.2, // flat_pixel
                41.6, // chain_visit
                521.1, // layer
                0.0, // layer_row
                83.5, // layer_edge
                183.2, // bent_edge
                244.8, // sum_row
                145.1, // row_chain
                112.1, // sum_part
                9.5, // sum_pixel
                0.0, // edge_group
                114.9, // line_crossing
                63.8, // span
                22.4, // fill
                0.4, // filled_pixel
                29.7, // blended_pixel
                31.1, // faded_pixel
            }),
    },
    // cortex-m7
    {
        .code = 69240,
        .fixed_ram = 4,
        .stack = 8856,
        .cycles = 1.68,
        .frame = 400,
        .area = 338,
        .work =
            std::to_array<double>({
                0.0, // picture
                2124.6, // item
                1911.7, // track
                331.3, // key
                0.0, // placement
                800.4, // law
                2484.6, // bezier_law
                0.0, // bone
                851.7, // object
                3763.2, // stroke
                300.0, // segment
                0.0, // line
                1046.3, // curve
                444.9, // split
                23.4, // point
                0.0, // wide_point
                262.5, // projected_point
                313.6, // carried_point
                581.1, // bent_point
                107.9, // piece
                251.0, // pen_piece
                90.3, // bend
                0.0, // slight_bend
                163.1, // placed_corner
                199.5, // corner
                417.4, // chain
                11.5, // crossing
                111.0, // kept_chain
                244.8, // step
                54.2, // passed_band
                0.0, // passed_border
                456.0, // band
                254.3, // band_chain
                299.1, // straight_chain
                73.2, // border
                178.0, // region
                137.1, // edge_row
                0.0, // flat_pixel
                42.1, // chain_visit
                510.7, // layer
                0.0, // layer_row
                84.8, // layer_edge
                176.0, // bent_edge
                247.2, // sum_row
                146.1, // row_chain
                115.0, // sum_part
                12.3, // sum_pixel
                0.0, // edge_group
                113.1, // line_crossing
                57.2, // span
                22.5, // fill
                0.5, // filled_pixel
                30.9, // blended_pixel
                32.3, // faded_pixel
            }),
    },
}};

}

const ProcessorCosts& costs_of(Processor processor) { return table[static_cast<std::size_t>(processor)]; }

}
