// Written by scripts/calibrate.

#include "host/fit/cost_table.hpp"

namespace kfast::fit {
namespace {

constexpr std::array<ProcessorCosts, processor_count> table{{
    // cortex-m0
    {
        .code = 57520,
        .fixed_ram = 4,
        .stack = 7996,
        .cycles = 1.58,
        .frame = 856,
        .area = 313,
        .work = std::to_array<double>({
            0.0,    // picture
            1907.4, // item
            2888.9, // track
            1401.9, // key
            0.0,    // placement
            1348.4, // law
            2674.3, // bezier_law
            0.0,    // bone
            3168.2, // object
            1393.8, // stroke
            192.1,  // line
            1836.3, // curve
            666.4,  // split
            150.2,  // point
            0.0,    // wide_point
            1068.6, // projected_point
            823.6,  // carried_point
            1086.6, // bent_point
            134.7,  // piece
            80.5,   // wide_piece
            335.6,  // pen_piece
            414.8,  // bend
            0.0,    // slight_bend
            208.7,  // corner
            225.4,  // chain
            29.1,   // copied_corner
            73.7,   // copied_chain
            0.0,    // strip
            676.8,  // searched_row
            0.2,    // step_visit
            580.9,  // swept_row
            323.3,  // straight_part
            678.6,  // bent_part
            185.7,  // edge
            1208.6, // slab
            237.5,  // slab_edge
            0.0,    // flat_edge
            171.7,  // crossed_pixel
            0.0,    // cell
            0.0,    // span
            0.0,    // compared
            88.1,   // marked
            383.6,  // inserted_run
            98.9,   // fill
            0.0,    // filled_pixel
            75.9,   // blended_pixel
            83.8,   // faded_pixel
        }),
    },
    // cortex-m3
    {
        .code = 53096,
        .fixed_ram = 4,
        .stack = 7676,
        .cycles = 1.77,
        .frame = 408,
        .area = 372,
        .work = std::to_array<double>({
            0.0,    // picture
            1434.0, // item
            1315.6, // track
            510.8,  // key
            0.0,    // placement
            619.5,  // law
            1817.7, // bezier_law
            0.0,    // bone
            1737.7, // object
            1035.3, // stroke
            78.6,   // line
            1472.4, // curve
            412.6,  // split
            131.7,  // point
            0.0,    // wide_point
            275.4,  // projected_point
            374.6,  // carried_point
            605.6,  // bent_point
            38.0,   // piece
            5.9,    // wide_piece
            197.3,  // pen_piece
            242.3,  // bend
            0.0,    // slight_bend
            194.1,  // corner
            146.7,  // chain
            18.0,   // copied_corner
            0.0,    // copied_chain
            29.4,   // strip
            528.1,  // searched_row
            9.5,    // step_visit
            325.0,  // swept_row
            111.1,  // straight_part
            296.4,  // bent_part
            89.2,   // edge
            187.1,  // slab
            221.4,  // slab_edge
            48.6,   // flat_edge
            0.0,    // crossed_pixel
            113.1,  // cell
            0.0,    // span
            28.6,   // compared
            158.0,  // marked
            119.2,  // inserted_run
            33.6,   // fill
            0.6,    // filled_pixel
            25.9,   // blended_pixel
            36.1,   // faded_pixel
        }),
    },
    // cortex-m4
    {
        .code = 53108,
        .fixed_ram = 4,
        .stack = 7676,
        .cycles = 1.77,
        .frame = 408,
        .area = 382,
        .work = std::to_array<double>({
            0.0,    // picture
            1434.1, // item
            1318.7, // track
            512.3,  // key
            0.0,    // placement
            617.7,  // law
            1816.4, // bezier_law
            0.0,    // bone
            1735.9, // object
            1036.1, // stroke
            77.5,   // line
            1470.5, // curve
            410.7,  // split
            131.8,  // point
            0.0,    // wide_point
            277.4,  // projected_point
            373.7,  // carried_point
            605.7,  // bent_point
            38.2,   // piece
            6.0,    // wide_piece
            197.3,  // pen_piece
            242.7,  // bend
            0.0,    // slight_bend
            194.0,  // corner
            146.9,  // chain
            18.1,   // copied_corner
            0.0,    // copied_chain
            0.0,    // strip
            529.5,  // searched_row
            9.2,    // step_visit
            330.4,  // swept_row
            109.0,  // straight_part
            297.3,  // bent_part
            87.1,   // edge
            188.4,  // slab
            223.8,  // slab_edge
            41.9,   // flat_edge
            0.0,    // crossed_pixel
            116.7,  // cell
            0.0,    // span
            28.6,   // compared
            172.3,  // marked
            118.2,  // inserted_run
            35.1,   // fill
            0.7,    // filled_pixel
            25.7,   // blended_pixel
            36.0,   // faded_pixel
        }),
    },
    // cortex-m7
    {
        .code = 53184,
        .fixed_ram = 4,
        .stack = 7676,
        .cycles = 1.65,
        .frame = 403,
        .area = 351,
        .work = std::to_array<double>({
            0.0,    // picture
            1434.8, // item
            1315.4, // track
            510.0,  // key
            0.0,    // placement
            615.9,  // law
            1805.0, // bezier_law
            0.0,    // bone
            1732.8, // object
            1036.2, // stroke
            77.3,   // line
            1470.5, // curve
            410.7,  // split
            131.8,  // point
            0.0,    // wide_point
            276.4,  // projected_point
            374.1,  // carried_point
            604.7,  // bent_point
            38.1,   // piece
            6.0,    // wide_piece
            197.3,  // pen_piece
            242.6,  // bend
            0.0,    // slight_bend
            194.1,  // corner
            147.0,  // chain
            18.1,   // copied_corner
            0.0,    // copied_chain
            0.0,    // strip
            561.2,  // searched_row
            9.6,    // step_visit
            315.9,  // swept_row
            134.5,  // straight_part
            325.0,  // bent_part
            83.6,   // edge
            157.0,  // slab
            229.9,  // slab_edge
            55.9,   // flat_edge
            13.4,   // crossed_pixel
            99.0,   // cell
            0.0,    // span
            31.0,   // compared
            137.1,  // marked
            121.6,  // inserted_run
            30.9,   // fill
            0.4,    // filled_pixel
            25.8,   // blended_pixel
            36.7,   // faded_pixel
        }),
    },
}};

}

const ProcessorCosts& costs_of(Processor processor) { return table[static_cast<std::size_t>(processor)]; }

}
