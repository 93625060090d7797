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
        .code = 57616,
        .fixed_ram = 4,
        .stack = 7996,
        .cycles = 1.58,
        .frame = 856,
        .area = 313,
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
                670.8, // searched_row
                0.1, // step_visit
                443.7, // swept_row
                329.2, // straight_part
                675.7, // bent_part
                187.4, // edge
                1201.3, // slab
                237.9, // slab_edge
                0.0, // flat_edge
                172.2, // crossed_pixel
                0.0, // cell
                0.0, // span
                0.0, // compared
                87.5, // marked
                382.7, // inserted_run
                103.2, // fill
                0.0, // filled_pixel
                76.0, // blended_pixel
                83.9, // faded_pixel
            }),
    },
    // cortex-m3
    {
        .code = 53224,
        .fixed_ram = 4,
        .stack = 7676,
        .cycles = 1.77,
        .frame = 408,
        .area = 392,
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
                0.0, // strip
                531.7, // searched_row
                9.4, // step_visit
                216.1, // swept_row
                109.5, // straight_part
                301.9, // bent_part
                91.5, // edge
                182.6, // slab
                221.6, // slab_edge
                45.8, // flat_edge
                0.0, // crossed_pixel
                114.5, // cell
                0.0, // span
                29.1, // compared
                158.7, // marked
                118.7, // inserted_run
                32.8, // fill
                0.7, // filled_pixel
                26.0, // blended_pixel
                36.2, // faded_pixel
            }),
    },
    // cortex-m4
    {
        .code = 53244,
        .fixed_ram = 4,
        .stack = 7676,
        .cycles = 1.76,
        .frame = 408,
        .area = 387,
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
                0.0, // strip
                529.6, // searched_row
                9.2, // step_visit
                220.1, // swept_row
                107.0, // straight_part
                304.2, // bent_part
                88.1, // edge
                184.0, // slab
                224.2, // slab_edge
                42.8, // flat_edge
                0.0, // crossed_pixel
                116.6, // cell
                0.0, // span
                29.8, // compared
                169.9, // marked
                117.4, // inserted_run
                35.9, // fill
                0.7, // filled_pixel
                25.8, // blended_pixel
                36.2, // faded_pixel
            }),
    },
    // cortex-m7
    {
        .code = 53296,
        .fixed_ram = 4,
        .stack = 7676,
        .cycles = 1.64,
        .frame = 403,
        .area = 356,
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
                0.0, // strip
                560.7, // searched_row
                9.5, // step_visit
                206.7, // swept_row
                132.5, // straight_part
                329.2, // bent_part
                84.2, // edge
                154.8, // slab
                230.2, // slab_edge
                56.0, // flat_edge
                11.6, // crossed_pixel
                101.1, // cell
                0.0, // span
                31.4, // compared
                140.0, // marked
                120.8, // inserted_run
                29.7, // fill
                0.4, // filled_pixel
                25.8, // blended_pixel
                36.8, // faded_pixel
            }),
    },
}};

}

const ProcessorCosts& costs_of(Processor processor) { return table[static_cast<std::size_t>(processor)]; }

}
