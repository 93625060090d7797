#include "core/math/flatten.hpp"
#include "core/player.hpp"
#include "core/pose/equalize.hpp"
#include "core/scene/drawing_view.hpp"
#include "core/time/track.hpp"
#include "core/time/velocity_law.hpp"

#include <array>

static_assert(__STDC_HOSTED__ == 0, "compiled with -ffreestanding");

namespace kfast::test {

/// Uses all that docs/library.md shows, so that the templates are compiled as well.
std::uint32_t points_between(DrawingView from, DrawingView to, Fraction time)
{
    std::uint32_t points = 0;
    const auto eased = progress(VelocityLaw::accelerate, time);
    EqualizedPair pair{from, to};
    while (const std::uint32_t segments = pair.next_stroke())
        for (std::uint32_t i = 0; i < segments; ++i) {
            const Pair<Segment> both = pair.next_segment();
            flatten(tween(both.a, both.b, eased, eased), 8, [&points](Point) { ++points; });
        }
    return points;
}

std::int32_t height_at(Time time)
{
    std::array<KeySample, 4> storage;
    Track track{storage};
    track.add(Time::frame(3), 7);
    return track.value_at(time) >> fine_bits;
}

}
