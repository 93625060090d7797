#include "host/compiler/object_style.hpp"

#include "core/kfb_limits.hpp"
#include "host/compiler/track_peak.hpp"

#include <algorithm>
#include <cmath>

namespace kfast {
namespace {

/// Any wider stroke has more than kfb::max_arc_pieces.
constexpr double widest = 1 << 20;

std::uint32_t pieces_of_arc(double width)
{
    const auto pieces =
        static_cast<std::uint32_t>(arc_pieces(static_cast<int>(std::ceil(std::min(width, widest)))));
    return std::min(pieces, kfb::max_arc_pieces);
}

}

ObjectStyle object_style(const scene::Object& object, const std::vector<scene::Track>& tracks, double scale)
{
    ObjectStyle style;
    style.is_filled = object.fill.has_value();
    style.is_stroked = object.stroke.has_value();
    style.fill_rule = object.fill_rule;
    style.fill = static_cast<std::uint8_t>(object.fill.value_or(0));
    if (const auto& stroke = object.stroke) {
        style.stroke = static_cast<std::uint8_t>(stroke->colour);
        style.width = stroke->width;
        style.cap = stroke->cap;
        style.join = stroke->join;
        style.miter_limit = stroke->miter_limit;
        style.arc_pieces = pieces_of_arc(track_peak(tracks, Property::width, stroke->width) * scale);
    }
    return style;
}

}
