#include "core/beam/leg_corners.hpp"

namespace kfast {

LegCorners::LegCorners(const BeamLines& lines, const BeamLeg& leg) : is_reversed_{leg.is_reversed}
{
    const BeamLine& line = lines.line(leg.line);
    points_ = lines.points(line).data();
    size_ = line.points;
    colour_ = line.colour;
    const bool is_closed = lines.is_closed(line);
    period_ = is_closed ? size_ - 1 : size_;
    if (is_closed)
        first_ = leg.start;
    else if (is_reversed_)
        first_ = size_ - 1;
}

FieldPoint LegCorners::operator[](std::uint32_t number) const
{
    if (is_reversed_)
        return points_[first_ < number ? first_ + period_ - number : first_ - number];
    const std::uint32_t place = first_ + number;
    return points_[place < period_ ? place : place - period_];
}

}
