// Written by scripts/calibrate.

#include "host/fit/cost_table.hpp"

namespace kfast::fit {
namespace {

constexpr std::array<ProcessorCosts, processor_count> table{{
    // cortex-m0
    {
        .code = 54276,
        .fixed_ram = 4,
        .stack = 7568,
        .cycles = 1.51,
        .frame = 844,
        .area = 23,
        .work =
            {
                0.0, // picture
                1649.3, // item
                1499.5, // track
                783.6, // key
                0.0, // placement
                1534.0, // law
                2595.7, // bezier_law
                0.0, // bone
                2415.7, // object
                1292.1, // stroke
                313.5, // line
                1797.7, // curve
                695.6, // split
                166.7, // point
                0.0, // wide_point
                1073.8, // projected_point
                838.5, // carried_point
                1040.1, // bent_point
                73.0, // piece
                315.6, // pen_piece
                439.0, // bend
                0.0, // slight_bend
                175.3, // corner
                219.1, // chain
                10.4, // copied_corner
                0.0, // strip
                44.0, // searched_row
                0.0, // step_visit
                1107.6, // swept_row
                28.6, // straight_part
                396.1, // part
                131.5, // bent_part
                260.2, // edge
                1807.4, // slab
                88.6, // slab_edge
                0.0, // flat_edge
                50.2, // crossed_pixel
                0.0, // cell
                0.0, // span
                0.0, // compared
                0.0, // marked
                653.1, // inserted_run
                0.0, // fill
                4.6, // filled_pixel
                124.3, // blended_pixel
                55.2, // faded_pixel
            },
    },
    // cortex-m3
    {
        .code = 50100,
        .fixed_ram = 4,
        .stack = 7128,
        .cycles = 1.68,
        .frame = 407,
        .area = 18,
        .work =
            {
                0.0, // picture
                1507.2, // item
                658.0, // track
                317.5, // key
                0.0, // placement
                848.4, // law
                1743.9, // bezier_law
                0.0, // bone
                986.5, // object
                1050.6, // stroke
                245.0, // line
                1650.8, // curve
                428.1, // split
                121.5, // point
                0.0, // wide_point
                278.9, // projected_point
                409.9, // carried_point
                681.8, // bent_point
                30.5, // piece
                191.2, // pen_piece
                344.4, // bend
                0.0, // slight_bend
                143.3, // corner
                131.1, // chain
                3.0, // copied_corner
                321.3, // strip
                427.4, // searched_row
                8.4, // step_visit
                316.3, // swept_row
                13.2, // straight_part
                168.4, // part
                202.5, // bent_part
                96.8, // edge
                363.3, // slab
                162.0, // slab_edge
                0.0, // flat_edge
                5.0, // crossed_pixel
                90.2, // cell
                0.0, // span
                0.0, // compared
                126.2, // marked
                167.2, // inserted_run
                118.4, // fill
                0.8, // filled_pixel
                32.4, // blended_pixel
                40.4, // faded_pixel
            },
    },
    // cortex-m4
    {
        .code = 50136,
        .fixed_ram = 4,
        .stack = 7128,
        .cycles = 1.67,
        .frame = 408,
        .area = 18,
        .work =
            {
                0.0, // picture
                1508.3, // item
                659.9, // track
                318.4, // key
                0.0, // placement
                846.3, // law
                1742.7, // bezier_law
                0.0, // bone
                983.7, // object
                1052.3, // stroke
                243.9, // line
                1649.2, // curve
                426.0, // split
                121.6, // point
                0.0, // wide_point
                280.9, // projected_point
                409.0, // carried_point
                681.9, // bent_point
                30.6, // piece
                191.3, // pen_piece
                345.3, // bend
                0.0, // slight_bend
                143.3, // corner
                132.0, // chain
                3.0, // copied_corner
                305.8, // strip
                436.1, // searched_row
                7.8, // step_visit
                322.7, // swept_row
                11.9, // straight_part
                164.8, // part
                206.5, // bent_part
                96.0, // edge
                368.9, // slab
                161.4, // slab_edge
                0.0, // flat_edge
                6.0, // crossed_pixel
                93.8, // cell
                0.0, // span
                0.0, // compared
                133.4, // marked
                166.7, // inserted_run
                122.9, // fill
                0.9, // filled_pixel
                32.3, // blended_pixel
                40.4, // faded_pixel
            },
    },
    // cortex-m7
    {
        .code = 50188,
        .fixed_ram = 4,
        .stack = 7128,
        .cycles = 1.58,
        .frame = 402,
        .area = 18,
        .work =
            {
                0.0, // picture
                1509.3, // item
                657.8, // track
                317.1, // key
                0.0, // placement
                843.1, // law
                1723.1, // bezier_law
                0.0, // bone
                983.4, // object
                1048.4, // stroke
                243.9, // line
                1649.1, // curve
                426.0, // split
                121.7, // point
                0.0, // wide_point
                280.0, // projected_point
                409.1, // carried_point
                680.2, // bent_point
                30.6, // piece
                191.3, // pen_piece
                343.7, // bend
                0.0, // slight_bend
                143.2, // corner
                130.8, // chain
                3.0, // copied_corner
                306.6, // strip
                447.7, // searched_row
                7.9, // step_visit
                315.3, // swept_row
                19.6, // straight_part
                198.9, // part
                184.8, // bent_part
                92.9, // edge
                338.5, // slab
                165.8, // slab_edge
                0.0, // flat_edge
                10.4, // crossed_pixel
                86.8, // cell
                0.0, // span
                0.0, // compared
                120.7, // marked
                168.8, // inserted_run
                112.0, // fill
                0.8, // filled_pixel
                31.2, // blended_pixel
                40.7, // faded_pixel
            },
    },
}};

}

const ProcessorCosts& costs_of(Processor processor) { return table[static_cast<std::size_t>(processor)]; }

}
