#include "core/beam/beam_pen.hpp"

#include <algorithm>

namespace kfast {
namespace {

/// Where a pixel coordinate lies in the field, rounded to nearest and held within it.
std::int32_t in_field(Fixed pixels, std::int32_t units)
{
    const std::int64_t place = (std::int64_t{pixels.raw()} * units + Fixed::one / 2) >> 16;
    return static_cast<std::int32_t>(std::clamp<std::int64_t>(place + field_least, field_least, field_most));
}

}

void BeamPen::begin(Point from)
{
    lines_.begin(colour_, item_);
    line_to(from);
}

void BeamPen::add(const Segment& segment)
{
    flatten(segment, sight_.pieces_of(segment), [this](Point to) { line_to(to); });
}

void BeamPen::end(Point, bool) { lines_.end(); }

void BeamPen::line_to(Point to)
{
    const Point seen = sight_(to);
    lines_.add({static_cast<std::int16_t>(in_field(seen.x, units_)),
                static_cast<std::int16_t>(-1 - in_field(seen.y, units_))});
}

}
