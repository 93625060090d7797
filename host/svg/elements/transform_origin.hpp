#pragma once

#include "host/art/geometry/affine.hpp"
#include "host/svg/markup/length.hpp"
#include "host/svg/parts/part.hpp"
#include "host/svg/style/style.hpp"

namespace kfast::svg {

/// The affine about the point that "transform-origin" names in the view box; as it is without one.
art::Affine about_origin(const art::Affine& affine, const Style& style, const Measure& measure);

/// Whether that point belongs to the box around the element instead: "transform-box: fill-box".
bool turns_about_own_box(const Style& style);

/// Then, the part's own transform about it.
art::Affine about_own_box(const Part& part, const Style& style);

/// What is said of the size of letters, in the units around; as outside if nothing is.
double font_size(const Style& style, const Measure& outside);

}
