// Written by scripts/calibrate.

#include "host/fit/cost_table.hpp"

namespace kfast::fit {
namespace {

constexpr std::array<ProcessorCosts, processor_count> table{{
    // cortex-m0
    {
        .code = 58064,
        .fixed_ram = 4,
        .stack = 7984,
        .cycles = 1.53,
        .frame = 856,
        .area = 140,
        .work =
            {
                0.0, // picture
                1832.1, // item
                2758.7, // track
                1360.6, // key
                103.4, // placement
                1314.7, // law
                2590.5, // bezier_law
                0.0, // bone
                3114.2, // object
                1511.1, // stroke
                188.5, // line
                1812.8, // curve
                691.3, // split
                159.3, // point
                0.0, // wide_point
                1074.1, // projected_point
                833.3, // carried_point
                1103.4, // bent_point
                159.0, // piece
                108.6, // wide_piece
                317.7, // pen_piece
                447.3, // bend
                0.0, // slight_bend
                168.1, // corner
                236.1, // chain
                33.4, // copied_corner
                0.0, // strip
                640.2, // searched_row
                0.0, // step_visit
                525.5, // swept_row
                137.4, // straight_part
                237.8, // part
                476.1, // bent_part
                226.0, // edge
                993.6, // slab
                241.2, // slab_edge
                0.0, // flat_edge
                146.8, // crossed_pixel
                46.8, // cell
                0.0, // span
                0.0, // compared
                247.8, // marked
                450.3, // inserted_run
                89.9, // fill
                0.0, // filled_pixel
                76.7, // blended_pixel
                64.9, // faded_pixel
            },
    },
    // cortex-m3
    {
        .code = 53376,
        .fixed_ram = 4,
        .stack = 7552,
        .cycles = 1.70,
        .frame = 408,
        .area = 380,
        .work =
            {
                0.0, // picture
                1635.4, // item
                1215.3, // track
                500.2, // key
                0.0, // placement
                648.6, // law
                1804.2, // bezier_law
                0.0, // bone
                1496.3, // object
                1084.1, // stroke
                101.2, // line
                1465.6, // curve
                422.9, // split
                127.5, // point
                0.0, // wide_point
                278.6, // projected_point
                378.9, // carried_point
                613.1, // bent_point
                58.6, // piece
                31.4, // wide_piece
                176.7, // pen_piece
                266.4, // bend
                0.0, // slight_bend
                154.5, // corner
                140.8, // chain
                7.8, // copied_corner
                0.0, // strip
                567.9, // searched_row
                7.7, // step_visit
                247.0, // swept_row
                0.0, // straight_part
                126.5, // part
                185.8, // bent_part
                104.2, // edge
                160.7, // slab
                185.2, // slab_edge
                7.3, // flat_edge
                0.0, // crossed_pixel
                119.8, // cell
                0.0, // span
                18.9, // compared
                219.2, // marked
                154.9, // inserted_run
                23.9, // fill
                1.2, // filled_pixel
                24.2, // blended_pixel
                36.6, // faded_pixel
            },
    },
    // cortex-m4
    {
        .code = 53460,
        .fixed_ram = 4,
        .stack = 7552,
        .cycles = 1.70,
        .frame = 408,
        .area = 374,
        .work =
            {
                0.0, // picture
                1635.1, // item
                1218.5, // track
                501.8, // key
                0.0, // placement
                645.7, // law
                1802.3, // bezier_law
                0.0, // bone
                1495.8, // object
                1085.0, // stroke
                100.1, // line
                1463.7, // curve
                421.0, // split
                127.6, // point
                0.0, // wide_point
                280.6, // projected_point
                378.0, // carried_point
                613.2, // bent_point
                58.8, // piece
                31.4, // wide_piece
                176.7, // pen_piece
                267.5, // bend
                0.0, // slight_bend
                154.5, // corner
                141.6, // chain
                7.8, // copied_corner
                0.0, // strip
                575.6, // searched_row
                7.6, // step_visit
                246.5, // swept_row
                0.0, // straight_part
                123.3, // part
                188.5, // bent_part
                105.2, // edge
                165.9, // slab
                184.5, // slab_edge
                5.3, // flat_edge
                0.0, // crossed_pixel
                124.4, // cell
                0.0, // span
                18.4, // compared
                230.2, // marked
                154.3, // inserted_run
                26.6, // fill
                1.3, // filled_pixel
                24.1, // blended_pixel
                36.6, // faded_pixel
            },
    },
    // cortex-m7
    {
        .code = 53504,
        .fixed_ram = 4,
        .stack = 7552,
        .cycles = 1.58,
        .frame = 403,
        .area = 377,
        .work =
            {
                0.0, // picture
                1637.1, // item
                1215.1, // track
                499.4, // key
                0.0, // placement
                644.6, // law
                1792.8, // bezier_law
                0.0, // bone
                1490.7, // object
                1084.3, // stroke
                100.1, // line
                1463.8, // curve
                420.9, // split
                127.6, // point
                0.0, // wide_point
                279.7, // projected_point
                378.4, // carried_point
                612.3, // bent_point
                58.8, // piece
                31.5, // wide_piece
                176.8, // pen_piece
                266.0, // bend
                0.0, // slight_bend
                154.4, // corner
                140.5, // chain
                7.8, // copied_corner
                0.0, // strip
                589.9, // searched_row
                7.9, // step_visit
                248.6, // swept_row
                0.0, // straight_part
                150.2, // part
                166.5, // bent_part
                100.0, // edge
                136.8, // slab
                189.4, // slab_edge
                9.3, // flat_edge
                0.0, // crossed_pixel
                119.9, // cell
                0.0, // span
                18.4, // compared
                218.2, // marked
                155.9, // inserted_run
                16.2, // fill
                1.2, // filled_pixel
                23.2, // blended_pixel
                36.9, // faded_pixel
            },
    },
}};

}

const ProcessorCosts& costs_of(Processor processor) { return table[static_cast<std::size_t>(processor)]; }

}
