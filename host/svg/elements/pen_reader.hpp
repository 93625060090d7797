#pragma once

#include "host/art/budget.hpp"
#include "host/art/losses.hpp"
#include "host/svg/markup/length.hpp"
#include "host/svg/parts/part.hpp"
#include "host/svg/style/style.hpp"

#include <string>

namespace kfast::svg {

/// How a line is drawn that is painted with `ink`; nothing where it has no width.
std::optional<Pen> pen(const Ink& ink, const Style& style, const Measure& measure, const std::string& layer,
                       art::Losses& losses);

/// The drawing as its line is dashed, or as it is where it is not. `path_length` is what the author says its
/// length is, 0 if nothing; `scale` is how much larger it is seen on the canvas.
art::Drawing dashed_line(const art::Drawing& drawing, const Style& style, const Measure& measure,
                         double path_length, double scale, const std::string& layer, art::Budget& budget,
                         art::Losses& losses);

}
