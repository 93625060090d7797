#pragma once

#include "core/beam/beam_route.hpp"
#include "tests/core/player_fixture.hpp"

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace kfast::test {

using LinePoints = std::vector<FieldPoint>;

/// Lines and the memory they lie in.
struct DrawnLines {
    std::vector<std::uint32_t> memory;
    BeamLines lines;

    /// `items` are the numbers of their items; without them, each line is one of its own.
    explicit DrawnLines(const std::vector<LinePoints>& all, const std::vector<std::uint32_t>& items = {})
        : memory(words_for(all)), lines{std::as_writable_bytes(std::span{memory})}
    {
        for (std::size_t i = 0; i < all.size(); ++i) {
            lines.begin({}, items.empty() ? static_cast<std::uint32_t>(i) : items[i]);
            for (const FieldPoint point : all[i])
                lines.add(point);
            lines.end();
        }
    }

    std::vector<BeamLeg> route(FieldPoint from = {}, std::uint32_t effort = default_route_effort) const
    {
        std::vector<BeamLeg> legs(lines.size());
        find_route(lines, from, legs, effort);
        return legs;
    }

    std::uint64_t travel() const { return travel_of(lines, route()); }

    std::vector<BeamLeg> as_drawn() const
    {
        std::vector<BeamLeg> legs(lines.size());
        for (std::size_t i = 0; i < legs.size(); ++i)
            legs[i].line = static_cast<std::uint16_t>(i);
        return legs;
    }

private:
    static std::size_t words_for(const std::vector<LinePoints>& all)
    {
        std::size_t words = 4;
        for (const LinePoints& points : all)
            words += points.size() + 3;
        return words;
    }
};

/// A line, a closed one, or a dot, anywhere and of any extent up to `reach`.
inline LinePoints random_line(std::mt19937& random, int reach)
{
    const auto place = [&random](int around, int within) {
        const int offset =
            within == 0 ? 0 : static_cast<int>(random() % (2U * static_cast<unsigned>(within))) - within;
        return static_cast<std::int16_t>(std::clamp(around + offset, -32768, 32767));
    };
    const FieldPoint centre{place(0, 30000), place(0, 30000)};
    LinePoints points(1 + random() % 5);
    for (FieldPoint& point : points)
        point = {place(centre.x, reach), place(centre.y, reach)};
    if (points.size() > 2 && random() % 2 == 0)
        points.push_back(points.front());
    return points;
}

inline std::vector<LinePoints> random_lines(std::mt19937& random, std::size_t count, int reach)
{
    std::vector<LinePoints> all(count);
    for (LinePoints& points : all)
        points = random_line(random, reach);
    return all;
}

}
