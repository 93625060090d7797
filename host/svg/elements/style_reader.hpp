#pragma once

#include "host/art/budget.hpp"
#include "host/art/geometry/affine.hpp"
#include "host/art/losses.hpp"
#include "host/svg/markup/length.hpp"
#include "host/svg/parts/part.hpp"
#include "host/svg/style/style.hpp"

#include <string>

namespace kfast::svg {

/// The affine about the point that "transform-origin" names in the view box; unchanged without one.
art::Affine about_origin(const art::Affine& affine, const Style& style, const Measure& measure);

/// Whether that point belongs to the box around the element instead: "transform-box: fill-box".
bool turns_about_own_box(const Style& style);

/// In that case, the part's own transform about it.
art::Affine about_own_box(const Part& part, const Style& style);

/// The font size, in the units around; that of the outside if none is set.
double font_size(const Style& style, const Measure& outside);

/// How a line that is painted with `ink` is drawn; nothing if it has no width.
std::optional<Pen> pen(const Ink& ink, const Style& style, const Measure& measure, const std::string& layer,
                       art::Losses& losses);

/// How the line of a drawing is dashed; the number of lengths is even. `path_length` is the length that the
/// author declares, 0 if none; `scale` is how much larger it is on the canvas.
Dashes dashes_of(const art::Drawing& drawing, const Style& style, const Measure& measure, double path_length,
                 double scale, const std::string& layer, art::Losses& losses);

/// Whether a scene has such dashes. Else they have to be drawn.
bool are_of_scenes(const Dashes& dashes, const art::Drawing& drawing);

/// Makes a dash that is about as long as the line a bit longer than it, whatever is rounded: an offset draws
/// the line, and neither end of it is to be seen too early or too late.
void draw_whole_line(Dashes& dashes, const art::Drawing& drawing, double scale);

}
