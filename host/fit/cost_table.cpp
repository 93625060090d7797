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
        .code = 62632,
        .fixed_ram = 4,
        .stack = 8324,
        .cycles = 1.57,
        .frame = 865,
        .area = 22,
        .work =
            std::to_array<double>({
                0.0, // picture
                2036.0, // item
                2772.0, // track
                1318.4, // key
                0.0, // placement
                1282.1, // law
                2714.1, // bezier_law
                0.0, // bone
                3426.0, // object
                1524.4, // stroke
                189.6, // line
                1814.8, // curve
                668.8, // split
                149.4, // point
                0.0, // wide_point
                1069.0, // projected_point
                524.8, // carried_point
                1083.3, // bent_point
                102.2, // piece
                79.8, // wide_piece
                341.5, // pen_piece
                411.6, // bend
                0.0, // slight_bend
                206.2, // corner
                217.9, // chain
                32.4, // copied_corner
                47.1, // copied_chain
                913.5, // strip
                93.1, // searched_row
                0.0, // step_visit
                527.0, // swept_row
                255.5, // straight_part
                484.1, // bent_part
                197.9, // edge
                1297.4, // slab
                243.0, // slab_edge
                0.0, // flat_edge
                135.2, // crossed_pixel
                0.0, // cell
                0.0, // span
                0.0, // compared
                68.7, // marked
                376.7, // inserted_run
                140.9, // fill
                1.0, // filled_pixel
                81.6, // blended_pixel
                78.9, // faded_pixel
            }),
    },
    // cortex-m3
    {
        .code = 58580,
        .fixed_ram = 4,
        .stack = 7988,
        .cycles = 1.74,
        .frame = 412,
        .area = 57,
        .work =
            std::to_array<double>({
                0.0, // picture
                1523.1, // item
                1291.4, // track
                499.4, // key
                0.0, // placement
                628.5, // law
                1859.7, // bezier_law
                0.0, // bone
                1754.7, // object
                1026.8, // stroke
                79.8, // line
                1460.9, // curve
                414.9, // split
                128.3, // point
                0.0, // wide_point
                275.1, // projected_point
                349.7, // carried_point
                606.1, // bent_point
                29.7, // piece
                3.1, // wide_piece
                195.7, // pen_piece
                242.6, // bend
                0.0, // slight_bend
                195.0, // corner
                143.7, // chain
                17.0, // copied_corner
                0.0, // copied_chain
                640.1, // strip
                178.4, // searched_row
                10.8, // step_visit
                334.3, // swept_row
                77.0, // straight_part
                258.4, // bent_part
                59.4, // edge
                290.9, // slab
                221.6, // slab_edge
                41.9, // flat_edge
                0.0, // crossed_pixel
                89.9, // cell
                0.0, // span
                27.7, // compared
                107.5, // marked
                137.3, // inserted_run
                96.4, // fill
                0.7, // filled_pixel
                31.9, // blended_pixel
                35.3, // faded_pixel
            }),
    },
    // cortex-m4
    {
        .code = 58580,
        .fixed_ram = 4,
        .stack = 7980,
        .cycles = 1.74,
        .frame = 412,
        .area = 51,
        .work =
            std::to_array<double>({
                0.0, // picture
                1522.8, // item
                1294.4, // track
                499.9, // key
                0.0, // placement
                626.4, // law
                1857.4, // bezier_law
                0.0, // bone
                1750.1, // object
                1027.4, // stroke
                78.7, // line
                1458.8, // curve
                412.9, // split
                128.4, // point
                0.0, // wide_point
                277.1, // projected_point
                348.9, // carried_point
                606.3, // bent_point
                29.9, // piece
                3.1, // wide_piece
                195.8, // pen_piece
                242.9, // bend
                0.0, // slight_bend
                195.0, // corner
                143.9, // chain
                17.1, // copied_corner
                0.0, // copied_chain
                643.6, // strip
                176.1, // searched_row
                10.2, // step_visit
                339.6, // swept_row
                76.2, // straight_part
                261.8, // bent_part
                58.7, // edge
                288.7, // slab
                224.2, // slab_edge
                38.0, // flat_edge
                0.0, // crossed_pixel
                92.4, // cell
                0.0, // span
                25.8, // compared
                107.8, // marked
                136.0, // inserted_run
                98.1, // fill
                0.8, // filled_pixel
                31.8, // blended_pixel
                35.3, // faded_pixel
            }),
    },
    // cortex-m7
    {
        .code = 58712,
        .fixed_ram = 4,
        .stack = 7980,
        .cycles = 1.62,
        .frame = 407,
        .area = 18,
        .work =
            std::to_array<double>({
                0.0, // picture
                1522.3, // item
                1292.6, // track
                499.8, // key
                0.0, // placement
                626.2, // law
                1857.5, // bezier_law
                0.0, // bone
                1751.6, // object
                1027.7, // stroke
                78.6, // line
                1458.8, // curve
                413.0, // split
                128.4, // point
                0.0, // wide_point
                276.1, // projected_point
                348.9, // carried_point
                605.2, // bent_point
                29.9, // piece
                3.1, // wide_piece
                195.7, // pen_piece
                242.9, // bend
                0.0, // slight_bend
                195.0, // corner
                143.9, // chain
                17.0, // copied_corner
                0.0, // copied_chain
                692.1, // strip
                181.2, // searched_row
                10.2, // step_visit
                328.5, // swept_row
                92.7, // straight_part
                282.0, // bent_part
                53.1, // edge
                267.2, // slab
                230.6, // slab_edge
                62.2, // flat_edge
                0.0, // crossed_pixel
                84.3, // cell
                0.0, // span
                29.4, // compared
                100.7, // marked
                136.8, // inserted_run
                86.7, // fill
                0.6, // filled_pixel
                31.1, // blended_pixel
                35.4, // faded_pixel
            }),
    },
}};

}

const ProcessorCosts& costs_of(Processor processor) { return table[static_cast<std::size_t>(processor)]; }

}
