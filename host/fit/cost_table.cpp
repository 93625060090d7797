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
    "copied_corner",
    "copied_chain",
    "strip",
    "searched_row",
    "step_visit",
    "swept_row",
    "straight_part",
    "bent_part",
    "edge",
    "slab",
    "slab_edge",
    "flat_edge",
    "crossed_pixel",
    "cell",
    "span",
    "compared",
    "marked",
    "inserted_run",
    "fill",
    "filled_pixel",
    "blended_pixel",
    "faded_pixel",
});
static_assert(kinds == work_names, "the kinds of work have changed: scripts/calibrate");

constexpr std::array<ProcessorCosts, processor_count> table{{
    // cortex-m0
    {
        .code = 57720,
        .fixed_ram = 4,
        .stack = 7996,
        .cycles = 1.57,
        .frame = 856,
        .area = 332,
        .work =
            std::to_array<double>({
                0.0, // picture
                1895.8, // item
                2906.1, // track
                1400.1, // key
                0.0, // placement
                1331.4, // law
                2668.0, // bezier_law
                0.0, // bone
                3193.6, // object
                1391.8, // stroke
                192.6, // line
                1838.0, // curve
                666.9, // split
                150.3, // point
                0.0, // wide_point
                1068.1, // projected_point
                823.8, // carried_point
                1087.5, // bent_point
                135.0, // piece
                80.5, // wide_piece
                335.1, // pen_piece
                415.8, // bend
                0.0, // slight_bend
                208.8, // corner
                224.2, // chain
                29.3, // copied_corner
                72.7, // copied_chain
                0.0, // strip
                674.6, // searched_row
                0.8, // step_visit
                425.8, // swept_row
                300.1, // straight_part
                668.3, // bent_part
                186.2, // edge
                1208.1, // slab
                238.5, // slab_edge
                0.0, // flat_edge
                173.6, // crossed_pixel
                0.0, // cell
                0.0, // span
                0.0, // compared
                80.2, // marked
                379.6, // inserted_run
                99.8, // fill
                0.0, // filled_pixel
                75.4, // blended_pixel
                83.1, // faded_pixel
            }),
    },
    // cortex-m3
    {
        .code = 53304,
        .fixed_ram = 4,
        .stack = 7676,
        .cycles = 1.76,
        .frame = 408,
        .area = 373,
        .work =
            std::to_array<double>({
                0.0, // picture
                1426.7, // item
                1326.6, // track
                510.5, // key
                0.0, // placement
                615.4, // law
                1821.1, // bezier_law
                0.0, // bone
                1750.1, // object
                1033.5, // stroke
                78.8, // line
                1473.0, // curve
                412.7, // split
                131.7, // point
                0.0, // wide_point
                275.1, // projected_point
                374.6, // carried_point
                606.3, // bent_point
                38.0, // piece
                5.8, // wide_piece
                197.0, // pen_piece
                242.0, // bend
                0.0, // slight_bend
                194.3, // corner
                146.1, // chain
                18.0, // copied_corner
                0.0, // copied_chain
                25.0, // strip
                533.0, // searched_row
                9.9, // step_visit
                210.8, // swept_row
                76.2, // straight_part
                289.7, // bent_part
                89.6, // edge
                183.3, // slab
                222.2, // slab_edge
                50.4, // flat_edge
                3.4, // crossed_pixel
                110.2, // cell
                0.0, // span
                30.8, // compared
                150.5, // marked
                117.2, // inserted_run
                36.7, // fill
                0.5, // filled_pixel
                26.3, // blended_pixel
                36.3, // faded_pixel
            }),
    },
    // cortex-m4
    {
        .code = 53300,
        .fixed_ram = 4,
        .stack = 7676,
        .cycles = 1.76,
        .frame = 408,
        .area = 368,
        .work =
            std::to_array<double>({
                0.0, // picture
                1426.8, // item
                1329.8, // track
                512.0, // key
                0.0, // placement
                613.6, // law
                1819.8, // bezier_law
                0.0, // bone
                1748.3, // object
                1034.3, // stroke
                77.7, // line
                1471.0, // curve
                410.7, // split
                131.8, // point
                0.0, // wide_point
                277.1, // projected_point
                373.7, // carried_point
                606.4, // bent_point
                38.2, // piece
                5.9, // wide_piece
                197.1, // pen_piece
                242.4, // bend
                0.0, // slight_bend
                194.2, // corner
                146.3, // chain
                18.1, // copied_corner
                0.0, // copied_chain
                16.8, // strip
                532.7, // searched_row
                9.6, // step_visit
                214.7, // swept_row
                75.2, // straight_part
                293.8, // bent_part
                86.1, // edge
                184.0, // slab
                224.8, // slab_edge
                46.6, // flat_edge
                4.6, // crossed_pixel
                111.8, // cell
                0.0, // span
                31.5, // compared
                161.0, // marked
                116.1, // inserted_run
                40.3, // fill
                0.5, // filled_pixel
                26.1, // blended_pixel
                36.3, // faded_pixel
            }),
    },
    // cortex-m7
    {
        .code = 53392,
        .fixed_ram = 4,
        .stack = 7676,
        .cycles = 1.64,
        .frame = 403,
        .area = 346,
        .work =
            std::to_array<double>({
                0.0, // picture
                1427.6, // item
                1326.4, // track
                509.7, // key
                0.0, // placement
                611.8, // law
                1808.5, // bezier_law
                0.0, // bone
                1745.1, // object
                1034.5, // stroke
                77.6, // line
                1471.0, // curve
                410.8, // split
                131.8, // point
                0.0, // wide_point
                276.2, // projected_point
                374.0, // carried_point
                605.4, // bent_point
                38.1, // piece
                5.8, // wide_piece
                197.0, // pen_piece
                242.3, // bend
                0.0, // slight_bend
                194.2, // corner
                146.4, // chain
                18.1, // copied_corner
                0.0, // copied_chain
                11.6, // strip
                565.0, // searched_row
                9.9, // step_visit
                200.2, // swept_row
                98.5, // straight_part
                317.1, // bent_part
                82.1, // edge
                155.7, // slab
                230.8, // slab_edge
                61.3, // flat_edge
                14.9, // crossed_pixel
                97.0, // cell
                0.0, // span
                33.2, // compared
                131.5, // marked
                119.2, // inserted_run
                32.6, // fill
                0.3, // filled_pixel
                26.0, // blended_pixel
                36.8, // faded_pixel
            }),
    },
}};

}

const ProcessorCosts& costs_of(Processor processor) { return table[static_cast<std::size_t>(processor)]; }

}
