#pragma once

#include "host/compiler/match/match_by_length.hpp"
#include "host/compiler/match/measured_stroke.hpp"

#include <doctest/doctest.h>
#include <vector>

namespace kfast::test {

inline MatchedDrawings matched(const scene::Drawing& a, const scene::Drawing& b)
{
    const std::optional<MatchedDrawings> drawings = match_by_length(a, b);
    REQUIRE(drawings);
    return *drawings;
}

using kfast::in_pixels;

inline Vec2 in_pixels(Point point) { return {point.x.raw() / 65536.0, point.y.raw() / 65536.0}; }

inline std::vector<scene::Point> vertices(const scene::Stroke& stroke)
{
    std::vector<scene::Point> points{stroke.from};
    for (const scene::Segment& segment : stroke.segments)
        points.push_back(segment.to);
    return points;
}

}
