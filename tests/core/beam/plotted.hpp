#pragma once

#include "core/beam/point_stream.hpp"
#include "tests/core/beam/line_store.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

/// Lines, and the points that a beam draws them with.
namespace kfast::test {

inline constexpr std::uint32_t any_budget = std::numeric_limits<std::uint32_t>::max();

using Points = std::vector<BeamPoint>;

inline Points all_of(PointStream plot, std::size_t piece = 7)
{
    Points points;
    std::vector<BeamPoint> some(piece);
    while (const std::size_t count = plot.next(some))
        points.insert(points.end(), some.begin(), some.begin() + static_cast<std::ptrdiff_t>(count));
    return points;
}

struct Plotted {
    BeamTiming timing;
    Points points;
};

inline Plotted plotted(const LineStore& store, const std::vector<BeamLeg>& legs, const BeamProfile& profile,
                       std::uint32_t budget = any_budget)
{
    const BeamTiming timing = find_timing(store.lines, legs, profile, budget, 0);
    return {timing, all_of({store.lines, legs, profile, timing})};
}

inline std::size_t count_at(const Points& points, FieldPoint at, bool is_lit)
{
    return static_cast<std::size_t>(std::ranges::count_if(
        points, [&](const BeamPoint& point) { return point.at == at && point.is_lit() == is_lit; }));
}

inline BeamProfile random_profile(RandomLines& random)
{
    const auto small = [&random](std::uint32_t max) { return static_cast<std::uint8_t>(random.number(max)); };
    BeamProfile profile{.rate = 1000 + random.number(99'000)};
    profile.lit_step = static_cast<std::uint16_t>(64 + random.number(4000));
    profile.travel_step = static_cast<std::uint16_t>(random.number(1) * (64 + random.number(9000)));
    profile.corner_dwell = small(20);
    profile.lit_dwell = small(5);
    profile.arrival_dwell = small(9);
    profile.leave_dwell = small(9);
    profile.light_delay = small(1) == 0 ? std::uint8_t{0} : small(20);
    return profile;
}

inline constexpr BeamProfile plain{.lit_step = 100, .park = {-32768, -32768}};

}
