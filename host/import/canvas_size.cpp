#include "host/import/canvas_size.hpp"

#include "host/art/prepare.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace kfast::importing {
namespace {

std::string size_text(double width, double height)
{
    std::ostringstream text;
    text << width << 'x' << height;
    return text.str();
}

double whole_side(double side) { return std::clamp(std::round(side), 1.0, double{longest_side}); }

}

void fit_canvas(art::Document& document, std::optional<Size> wanted, art::Losses& losses)
{
    const std::string before = size_text(document.width, document.height);
    const Size room = wanted.value_or(Size{longest_side, longest_side});
    const double factor = std::min(room.width / document.width, room.height / document.height);
    const bool is_scaled = wanted ? factor != 1 : factor < 1;
    if (is_scaled)
        art::scale(document, factor);
    document.width = whole_side(document.width);
    document.height = whole_side(document.height);
    if (is_scaled && !wanted)
        losses.add({"canvas of " + before + " pixels", "", std::nullopt,
                    "all of it smaller, on " + size_text(document.width, document.height)});
}

}
