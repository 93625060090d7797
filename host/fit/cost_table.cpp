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
    "timeline",
    "key",
    "item",
    "track",
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
        .code = 78548,
        .fixed_ram = 4,
        .stack = 8536,
        .cycles = 1.68,
        .frame = 831,
        .area = 534,
        .work =
            std::to_array<double>({
                2922.3, // picture
                186.3, // timeline
                999.7, // key
                532.8, // item
                983.1, // track
                938.0, // placement
                553.4, // law
                3437.9, // bezier_law
                2418.2, // bone
                0.0, // object
                1585.2, // stroke
                797.5, // segment
                0.0, // line
                212.3, // curve
                1052.2, // split
                146.9, // point
                0.0, // wide_point
                1090.7, // projected_point
                166.8, // carried_point
                600.3, // bent_point
                63.9, // piece
                426.6, // pen_piece
                213.8, // bend
                0.0, // slight_bend
                199.3, // placed_corner
                261.7, // corner
                609.8, // chain
                7.7, // crossing
                53.0, // kept_chain
                300.7, // step
                84.8, // passed_band
                0.0, // passed_border
                551.9, // band
                328.9, // band_chain
                378.4, // straight_chain
                53.0, // border
                235.0, // region
                142.5, // edge_row
                9.3, // flat_pixel
                44.8, // chain_visit
                519.6, // layer
                0.0, // layer_row
                135.2, // layer_edge
                311.6, // bent_edge
                281.7, // sum_row
                180.1, // row_chain
                138.8, // sum_part
                15.8, // sum_pixel
                0.0, // edge_group
                152.2, // line_crossing
                78.0, // span
                24.5, // fill
                0.0, // filled_pixel
                33.6, // blended_pixel
                49.0, // faded_pixel
            }),
    },
    // cortex-m3
    {
        .code = 75288,
        .fixed_ram = 4,
        .stack = 8472,
        .cycles = 1.80,
        .frame = 426,
        .area = 412,
        .work =
            std::to_array<double>({
                2145.1, // picture
                112.3, // timeline
                1051.6, // key
                456.8, // item
                800.4, // track
                90.1, // placement
                244.5, // law
                2165.5, // bezier_law
                1163.1, // bone
                0.0, // object
                909.8, // stroke
                526.5, // segment
                0.0, // line
                220.1, // curve
                881.6, // split
                108.6, // point
                0.0, // wide_point
                398.3, // projected_point
                174.8, // carried_point
                503.7, // bent_point
                40.9, // piece
                260.7, // pen_piece
                40.0, // bend
                0.0, // slight_bend
                128.6, // placed_corner
                208.0, // corner
                476.9, // chain
                7.4, // crossing
                40.7, // kept_chain
                226.3, // step
                59.0, // passed_band
                0.0, // passed_border
                436.1, // band
                285.0, // band_chain
                323.6, // straight_chain
                42.1, // border
                202.6, // region
                102.5, // edge_row
                2.5, // flat_pixel
                37.1, // chain_visit
                402.9, // layer
                0.0, // layer_row
                108.6, // layer_edge
                215.9, // bent_edge
                198.4, // sum_row
                149.4, // row_chain
                107.4, // sum_part
                12.3, // sum_pixel
                0.0, // edge_group
                119.8, // line_crossing
                63.9, // span
                19.6, // fill
                0.7, // filled_pixel
                23.5, // blended_pixel
                33.6, // faded_pixel
            }),
    },
    // cortex-m4
    {
        .code = 75260,
        .fixed_ram = 4,
        .stack = 8464,
        .cycles = 1.80,
        .frame = 428,
        .area = 410,
        .work =
            std::to_array<double>({
                2149.1, // picture
                112.3, // timeline
                1050.7, // key
                456.7, // item
                805.5, // track
                89.8, // placement
                244.4, // law
                2184.1, // bezier_law
                1174.9, // bone
                0.0, // object
                906.2, // stroke
                525.5, // segment
                0.0, // line
                220.4, // curve
                877.9, // split
                107.7, // point
                0.0, // wide_point
                400.0, // projected_point
                174.0, // carried_point
                503.8, // bent_point
                41.6, // piece
                261.7, // pen_piece
                31.3, // bend
                0.0, // slight_bend
                130.3, // placed_corner
                209.8, // corner
                482.2, // chain
                7.5, // crossing
                40.7, // kept_chain
                226.5, // step
                60.1, // passed_band
                0.0, // passed_border
                436.6, // band
                284.6, // band_chain
                322.0, // straight_chain
                42.3, // border
                202.1, // region
                102.5, // edge_row
                3.1, // flat_pixel
                36.9, // chain_visit
                406.2, // layer
                0.0, // layer_row
                107.7, // layer_edge
                229.0, // bent_edge
                201.1, // sum_row
                148.5, // row_chain
                107.3, // sum_part
                11.6, // sum_pixel
                0.0, // edge_group
                119.6, // line_crossing
                64.8, // span
                20.0, // fill
                0.7, // filled_pixel
                23.6, // blended_pixel
                32.6, // faded_pixel
            }),
    },
    // cortex-m7
    {
        .code = 75336,
        .fixed_ram = 4,
        .stack = 8464,
        .cycles = 1.65,
        .frame = 423,
        .area = 424,
        .work =
            std::to_array<double>({
                2142.1, // picture
                112.3, // timeline
                1051.4, // key
                456.5, // item
                798.9, // track
                94.3, // placement
                244.2, // law
                2165.7, // bezier_law
                1168.7, // bone
                0.0, // object
                909.1, // stroke
                525.7, // segment
                0.0, // line
                220.2, // curve
                877.6, // split
                108.6, // point
                0.0, // wide_point
                400.3, // projected_point
                173.8, // carried_point
                504.3, // bent_point
                40.8, // piece
                260.7, // pen_piece
                40.8, // bend
                0.0, // slight_bend
                128.6, // placed_corner
                208.1, // corner
                476.9, // chain
                7.4, // crossing
                40.7, // kept_chain
                227.9, // step
                59.8, // passed_band
                0.0, // passed_border
                436.3, // band
                285.9, // band_chain
                323.4, // straight_chain
                42.4, // border
                194.5, // region
                106.0, // edge_row
                1.8, // flat_pixel
                37.3, // chain_visit
                394.5, // layer
                0.0, // layer_row
                109.7, // layer_edge
                222.4, // bent_edge
                202.7, // sum_row
                149.6, // row_chain
                110.3, // sum_part
                14.1, // sum_pixel
                0.0, // edge_group
                118.1, // line_crossing
                58.6, // span
                20.5, // fill
                0.8, // filled_pixel
                24.5, // blended_pixel
                33.7, // faded_pixel
            }),
    },
    // cortex-m33
    {
        .code = 75336,
        .fixed_ram = 4,
        .stack = 8472,
        .cycles = 1.79,
        .frame = 428,
        .area = 412,
        .work =
            std::to_array<double>({
                2145.7, // picture
                112.3, // timeline
                1051.0, // key
                456.8, // item
                800.1, // track
                91.4, // placement
                244.5, // law
                2165.6, // bezier_law
                1170.9, // bone
                0.0, // object
                908.7, // stroke
                525.9, // segment
                0.0, // line
                220.2, // curve
                877.6, // split
                108.6, // point
                0.0, // wide_point
                399.0, // projected_point
                173.8, // carried_point
                503.9, // bent_point
                40.8, // piece
                260.6, // pen_piece
                39.9, // bend
                0.0, // slight_bend
                128.6, // placed_corner
                208.1, // corner
                476.9, // chain
                7.4, // crossing
                40.7, // kept_chain
                226.6, // step
                60.0, // passed_band
                0.0, // passed_border
                436.3, // band
                285.0, // band_chain
                323.6, // straight_chain
                42.2, // border
                202.5, // region
                102.6, // edge_row
                2.5, // flat_pixel
                37.1, // chain_visit
                403.3, // layer
                0.0, // layer_row
                108.6, // layer_edge
                215.9, // bent_edge
                198.4, // sum_row
                149.3, // row_chain
                107.4, // sum_part
                12.3, // sum_pixel
                0.0, // edge_group
                119.8, // line_crossing
                63.8, // span
                19.6, // fill
                0.7, // filled_pixel
                23.5, // blended_pixel
                33.6, // faded_pixel
            }),
    },
}};

}

const ProcessorCosts& costs_of(Processor processor) { return table[static_cast<std::size_t>(processor)]; }

}
