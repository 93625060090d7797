#include "core/beam/beam_route.hpp"

namespace kfast {

void find_route(const BeamLines& lines, FieldPoint, std::span<BeamLeg> legs)
{
    for (std::size_t number = 0; number < lines.size(); ++number)
        legs[number] = {.line = static_cast<std::uint16_t>(number)};
}

}
