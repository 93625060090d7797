// Written by scripts/calibrate.

#include "host/fit/cost_table.hpp"

namespace kfast::fit {
namespace {

constexpr std::array<ProcessorCosts, processor_count> table{{
    // cortex-m0
    {
        .code = 68132,
        .fixed_ram = 4,
        .stack = 8728,
        .cycles = 1.51,
        .frame = 916,
        .area = 18,
        .work =
            {
                0.0, // picture
                1629.9, // item
                1431.4, // track
                654.5, // key
                0.0, // placement
                1667.4, // law
                2437.1, // bezier_law
                0.0, // bone
                2702.3, // object
                1110.4, // stroke
                449.2, // line
                1656.7, // curve
                651.6, // split
                149.6, // point
                0.0, // wide_point
                1041.1, // projected_point
                690.0, // carried_point
                936.2, // bent_point
                120.0, // piece
                336.0, // pen_piece
                353.3, // bend
                0.0, // slight_bend
                139.3, // corner
                210.2, // chain
                5.2, // copied_corner
                0.0, // searched_row
                107.6, // step_visit
                421.4, // swept_row
                115.9, // part
                0.0, // bent_part
                0.0, // edge
                0.0, // slab
                0.0, // slab_edge
                0.0, // cell
                684.7, // span
                1319.1, // compared
                330.8, // inserted_run
                0.0, // fill
                0.0, // filled_pixel
                33.7, // blended_pixel
                27.1, // faded_pixel
            },
    },
    // cortex-m3
    {
        .code = 60912,
        .fixed_ram = 4,
        .stack = 8232,
        .cycles = 1.67,
        .frame = 398,
        .area = 436,
        .work =
            {
                0.0, // picture
                1213.1, // item
                375.3, // track
                285.3, // key
                0.0, // placement
                725.8, // law
                1352.0, // bezier_law
                0.0, // bone
                1141.1, // object
                621.7, // stroke
                232.1, // line
                1092.1, // curve
                237.0, // split
                88.5, // point
                0.0, // wide_point
                262.3, // projected_point
                301.5, // carried_point
                452.9, // bent_point
                42.5, // piece
                209.6, // pen_piece
                185.3, // bend
                0.0, // slight_bend
                102.5, // corner
                164.2, // chain
                4.4, // copied_corner
                577.1, // searched_row
                10.0, // step_visit
                563.4, // swept_row
                127.1, // part
                186.5, // bent_part
                124.2, // edge
                364.2, // slab
                171.7, // slab_edge
                92.9, // cell
                0.0, // span
                0.0, // compared
                219.2, // inserted_run
                151.3, // fill
                1.2, // filled_pixel
                33.2, // blended_pixel
                36.8, // faded_pixel
            },
    },
    // cortex-m4
    {
        .code = 60936,
        .fixed_ram = 4,
        .stack = 8224,
        .cycles = 1.66,
        .frame = 398,
        .area = 429,
        .work =
            {
                0.0, // picture
                1218.5, // item
                371.1, // track
                283.2, // key
                0.0, // placement
                725.9, // law
                1349.4, // bezier_law
                0.0, // bone
                1139.8, // object
                617.4, // stroke
                227.5, // line
                1096.4, // curve
                239.7, // split
                88.6, // point
                0.0, // wide_point
                264.5, // projected_point
                309.7, // carried_point
                457.2, // bent_point
                41.7, // piece
                212.1, // pen_piece
                182.6, // bend
                0.0, // slight_bend
                103.5, // corner
                162.9, // chain
                4.4, // copied_corner
                566.2, // searched_row
                9.5, // step_visit
                571.9, // swept_row
                121.7, // part
                198.1, // bent_part
                125.1, // edge
                364.7, // slab
                170.4, // slab_edge
                95.5, // cell
                0.0, // span
                0.0, // compared
                218.6, // inserted_run
                159.5, // fill
                1.2, // filled_pixel
                33.4, // blended_pixel
                36.5, // faded_pixel
            },
    },
    // cortex-m7
    {
        .code = 60364,
        .fixed_ram = 4,
        .stack = 8240,
        .cycles = 1.56,
        .frame = 390,
        .area = 412,
        .work =
            {
                0.0, // picture
                1225.9, // item
                373.7, // track
                287.1, // key
                0.0, // placement
                732.8, // law
                1317.8, // bezier_law
                0.0, // bone
                1173.0, // object
                605.2, // stroke
                237.3, // line
                1090.8, // curve
                235.4, // split
                88.3, // point
                0.0, // wide_point
                237.5, // projected_point
                289.6, // carried_point
                452.6, // bent_point
                41.9, // piece
                218.0, // pen_piece
                173.5, // bend
                0.0, // slight_bend
                104.2, // corner
                164.8, // chain
                4.5, // copied_corner
                580.2, // searched_row
                9.5, // step_visit
                569.1, // swept_row
                126.0, // part
                191.9, // bent_part
                120.2, // edge
                363.9, // slab
                171.0, // slab_edge
                92.2, // cell
                0.0, // span
                0.0, // compared
                218.9, // inserted_run
                158.4, // fill
                1.2, // filled_pixel
                33.7, // blended_pixel
                36.8, // faded_pixel
            },
    },
}};

}

const ProcessorCosts& costs_of(Processor processor) { return table[static_cast<std::size_t>(processor)]; }

}
