#include "host/geometry/sector.hpp"

#include "host/geometry/unit_circle.hpp"

#include <cmath>
#include <numbers>

namespace kfast::scene {
namespace {

Vec2 on_canvas(const Sector& sector, Vec2 unit)
{
    return sector.centre + Vec2{sector.radius_x * unit.x, sector.radius_y * unit.y};
}

Curve piece(const Sector& sector, double from, double to)
{
    const Curve unit =
        unit_arc(on_unit_circle(from), on_unit_circle(to), (to - from) * std::numbers::pi / 180);
    return cubic_to(on_canvas(sector, unit.c1), on_canvas(sector, unit.c2), on_canvas(sector, unit.to));
}

Vec2 begin(const Sector& sector) { return on_canvas(sector, on_unit_circle(sector.from)); }

void append_arc(Outline& outline, const Sector& sector)
{
    const double extent = sector.to - sector.from;
    const int count = arc_pieces(std::abs(extent) / 90);
    const auto angle = [&](int i) { return sector.from + extent * i / count; };
    for (int i = 0; i < count; ++i)
        outline.curves.push_back(piece(sector, angle(i), angle(i + 1)));
}

}

Outline arc(const Sector& sector)
{
    Outline outline{.from = begin(sector), .curves = {}, .closed = false, .sector = sector};
    append_arc(outline, sector);
    return outline;
}

Outline pie(const Sector& sector)
{
    Outline outline{
        .from = sector.centre, .curves = {line_to(begin(sector))}, .closed = true, .sector = sector};
    append_arc(outline, sector);
    return outline;
}

Outline ring_piece(const Sector& sector, double inner)
{
    const Sector back{sector.centre, inner, inner, sector.to, sector.from};
    Outline outline = arc(sector);
    outline.closed = true;
    outline.curves.push_back(line_to(begin(back)));
    append_arc(outline, back);
    return outline;
}

}
