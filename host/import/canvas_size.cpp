#include "host/import/canvas_size.hpp"

#include "host/art/prepare/prepare.hpp"

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

void fit_canvas(art::Document& document, std::optional<Size> wanted, double share, art::Losses& losses)
{
    const std::string before = size_text(document.width, document.height);
    const Size room = wanted.value_or(Size{longest_side, longest_side});
    const double fitting = std::min(room.width / document.width, room.height / document.height);
    const double factor = share * (wanted ? fitting : std::min(fitting, 1.0));
    if (factor != 1)
        art::scale(document, factor);
    document.width = whole_side(document.width);
    document.height = whole_side(document.height);
    if (factor != 1 && !wanted)
        losses.add({"canvas of " + before + " pixels", "", std::nullopt,
                    "all of it smaller, on " + size_text(document.width, document.height)});
}

double share_within_reach(const art::Document& fitted, const scene_text::Reach& reach, bool is_smaller)
{
    // Simplification does the same to art of another size only nearly.
    constexpr double room = 0.999 * scene_text::widest_reach;
    const double share = room / std::max(is_smaller ? reach.left_alone : reach.in_groups, 1.0);
    if (!is_smaller && reach.in_groups <= longest_side) // nothing is cut
        return 1;
    const bool is_sensible = share * std::max(fitted.width, fitted.height) >= min_longer_side;
    return share < 1 && is_sensible ? share : 1;
}

}
