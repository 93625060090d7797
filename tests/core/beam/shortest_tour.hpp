#pragma once

#include "core/beam/beam_lines.hpp"
#include "core/beam/beam_profile.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace kfast::test {

/// The least travel of any closed tour through `lines`: of all orders, directions and starts. Tells nothing
/// but that, by going through all sets of lines (M. Held and R. M. Karp); up to a dozen lines.
class ShortestTour {
public:
    explicit ShortestTour(const BeamLines& lines) : lines_{lines}, ways_(lines.size())
    {
        for (std::size_t number = 0; number < lines.size(); ++number)
            ways_[number] = ways_through(static_cast<std::uint16_t>(number));
    }

    std::uint64_t travel() const
    {
        std::int64_t min = std::numeric_limits<std::int64_t>::max();
        if (ways_.empty())
            return 0;
        for (const Way& first : ways_[0])
            min = std::min(min, travel_from(first));
        return static_cast<std::uint64_t>(min);
    }

private:
    /// How a line is followed: from where to where.
    struct Way {
        FieldPoint begin;
        FieldPoint end;
    };

    std::vector<Way> ways_through(std::uint16_t number) const
    {
        const BeamLine& line = lines_.line(number);
        const auto points = lines_.points(line);
        std::vector<Way> ways;
        if (lines_.is_closed(line))
            for (const FieldPoint point : points)
                ways.push_back({point, point});
        else
            ways = {{points.front(), points.back()}, {points.back(), points.front()}};
        return ways;
    }

    /// Of the tours that begin with a way through line 0.
    std::int64_t travel_from(const Way& first) const
    {
        const std::size_t sets = std::size_t{1} << ways_.size();
        // least[set][line][way]: of a path from `first` through the set to the end of that way
        std::vector<Travels> min(sets, unknown());
        const auto extend = [&](std::size_t set, FieldPoint at, std::int64_t travel) {
            for (std::size_t line = 1; line < ways_.size(); ++line) {
                if ((set >> line & 1) != 0)
                    continue;
                for (std::size_t way = 0; way < ways_[line].size(); ++way) {
                    std::int64_t& there = min[set | std::size_t{1} << line][line][way];
                    there = std::min(there, travel + beam_travel(at, ways_[line][way].begin));
                }
            }
        };
        extend(1, first.end, 0);
        std::int64_t whole = ways_.size() == 1 ? beam_travel(first.end, first.begin) : far;
        for (std::size_t set = 1; set < sets; ++set)
            for (std::size_t line = 1; line < ways_.size(); ++line)
                for (std::size_t way = 0; way < ways_[line].size(); ++way) {
                    const std::int64_t travel = min[set][line][way];
                    if (travel == far)
                        continue;
                    extend(set, ways_[line][way].end, travel);
                    if (set == sets - 1)
                        whole = std::min(whole, travel + beam_travel(ways_[line][way].end, first.begin));
                }
        return whole;
    }

    using Travels = std::vector<std::vector<std::int64_t>>; ///< of each line and way

    Travels unknown() const
    {
        Travels travels(ways_.size());
        for (std::size_t line = 0; line < ways_.size(); ++line)
            travels[line].assign(ways_[line].size(), far);
        return travels;
    }

    static constexpr std::int64_t far = std::numeric_limits<std::int64_t>::max() / 2;

    const BeamLines& lines_;
    std::vector<std::vector<Way>> ways_;
};

}
