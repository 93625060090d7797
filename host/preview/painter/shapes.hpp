#pragma once

#include "host/preview/painter/painter.hpp"

namespace kfast {

/// `width` pixels wide, with flat ends.
void draw_line(Painter& painter, WindowSpot from, WindowSpot to, double width, Colour colour);
void draw_disc(Painter& painter, WindowSpot centre, double radius, Colour colour);
void draw_diamond(Painter& painter, WindowSpot centre, double radius, Colour colour);
/// Its corners are quarters of circles; `radius` is at most half of each side.
void draw_round_rect(Painter& painter, Rect area, double radius, Colour colour);
/// One pixel wide, within the area.
void draw_frame(Painter& painter, Rect area, Colour colour);
void draw_ring(Painter& painter, WindowSpot centre, double inner, double outer, Colour colour);
/// What of a square lies outside of the circle in it.
void fill_corners(Painter& painter, Rect square, Colour colour);

}
