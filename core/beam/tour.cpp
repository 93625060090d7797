#include "core/beam/tour.hpp"

namespace kfast {

void Tour::reverse(std::size_t first, std::size_t last)
{
    const std::span<BeamLeg> section = legs_.subspan(first, last - first + 1);
    std::reverse(section.begin(), section.end());
    for (BeamLeg& leg : section)
        leg = reversed(lines_, leg);
}

std::size_t Tour::move(std::size_t first, std::size_t count, std::size_t place)
{
    const auto at = [this](std::size_t index) { return legs_.begin() + static_cast<std::ptrdiff_t>(index); };
    if (place < first) {
        std::rotate(at(place), at(first), at(first + count));
        return place;
    }
    std::rotate(at(first), at(first + count), at(place));
    return place - count;
}

std::span<const FieldPoint> Tour::starts_of(std::size_t place) const
{
    const BeamLine& line = lines_.line(legs_[place].line);
    return lines_.is_closed(line) ? lines_.points(line).first(line.points - std::size_t{1})
                                  : std::span<const FieldPoint>{};
}

}
