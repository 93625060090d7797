#pragma once

#include "core/beam/beam_lines.hpp"
#include "core/beam/beam_route.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

namespace kfast::test {

/// Lines and the memory that they lie in.
struct LineStore {
    std::vector<std::uint32_t> memory;
    BeamLines lines;

    explicit LineStore(std::size_t bytes = 100'000)
        : memory(bytes / 4), lines{std::as_writable_bytes(std::span{memory})}
    {
    }

    void add(const std::vector<FieldPoint>& points, Colour colour = {255, 255, 255, 255})
    {
        lines.begin(colour, 0);
        for (const FieldPoint point : points)
            lines.add(point);
        lines.end();
    }

    std::vector<FieldPoint> points(std::size_t number) const
    {
        const auto all = lines.points(lines.line(number));
        return {all.begin(), all.end()};
    }

    /// In the order in which they were added.
    std::vector<BeamLeg> legs() const
    {
        std::vector<BeamLeg> all(lines.size());
        for (std::size_t number = 0; number < all.size(); ++number)
            all[number].line = static_cast<std::uint16_t>(number);
        return all;
    }
};

/// Lines of all sizes, closed and open, dots, ones that begin where others end; and routes along them.
class RandomLines {
public:
    explicit RandomLines(std::uint32_t seed) : random_{seed} {}

    void fill(LineStore& store, unsigned max_lines, unsigned max_points)
    {
        for (auto left = random_() % (max_lines + 1); left > 0; --left)
            store.add(line(max_points), colour());
    }

    std::vector<BeamLeg> legs(const LineStore& store)
    {
        std::vector<BeamLeg> all = store.legs();
        std::shuffle(all.begin(), all.end(), random_);
        for (BeamLeg& leg : all) {
            const BeamLine& line = store.lines.line(leg.line);
            leg.is_reversed = random_() % 2 == 0;
            if (store.lines.is_closed(line))
                leg.start = static_cast<std::uint16_t>(random_() % (line.points - 1U));
        }
        return all;
    }

    std::uint32_t number(std::uint32_t max)
    {
        return static_cast<std::uint32_t>(random_() % (std::uint64_t{max} + 1));
    }

private:
    std::vector<FieldPoint> line(unsigned max_points)
    {
        const int bits = 1 + static_cast<int>(random_() % 17);
        std::vector<FieldPoint> points{random_() % 4 == 0 ? last_ : away(last_, 17)};
        for (auto left = random_() % max_points; left > 0; --left)
            points.push_back(away(points.back(), bits));
        if (random_() % 3 == 0)
            points.push_back(points.front());
        last_ = points.back();
        return points;
    }

    FieldPoint away(FieldPoint from, int bits)
    {
        const auto moved = [this, bits](std::int32_t coordinate) {
            const auto delta = static_cast<std::int32_t>(random_()) >> (32 - bits);
            return static_cast<std::int16_t>(std::clamp(coordinate + delta, field_min, field_max));
        };
        const std::int16_t x = moved(from.x);
        return {x, moved(from.y)};
    }

    Colour colour()
    {
        const auto channel = [this] { return static_cast<std::uint8_t>(random_()); };
        const std::uint8_t red = channel();
        return {red, channel(), 255, 255};
    }

    std::mt19937 random_;
    FieldPoint last_;
};

}
