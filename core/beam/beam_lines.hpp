#pragma once

#include "core/beam/beam_profile.hpp"
#include "core/pixel/paint_style.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// A line of straight pieces in one colour. It is closed if its last point is its first one.
struct BeamLine {
    std::uint16_t first_point = 0; ///< the number of its first point
    std::uint16_t points = 0;      ///< at least one, which is a dot
    Colour colour;                 ///< opaque
    std::uint32_t item = 0;        ///< identifies an item of the scene, wherever symbols are used
};

/// The lit lines of one picture, in memory that the caller lends: points fill it from the front, lines from
/// the back.
class BeamLines {
public:
    static constexpr std::size_t max_points = 0xFFFF;
    /// The maximum number of lines that find room in `bytes` bytes.
    static constexpr std::size_t max_in(std::size_t bytes)
    {
        return std::min(bytes / (sizeof(FieldPoint) + sizeof(BeamLine)), max_points);
    }

    BeamLines() = default;
    /// `storage` is aligned to 4 bytes, and its size a multiple of 4.
    explicit BeamLines(std::span<std::byte> storage);

    void clear();
    /// From here to end() points belong to a new line. A point that is equal to the previous one is left out.
    void begin(Colour colour, std::uint32_t item);
    void add(FieldPoint point);
    void end();
    /// Called instead of end(): drops the line.
    void drop();
    /// The number of points of the line that is being added.
    std::uint32_t open_points() const { return open_.points; }

    std::size_t size() const { return line_count_; }
    /// The number of points of all lines.
    std::size_t corners() const { return point_count_; }
    /// The lines are in the order in which they were added.
    const BeamLine& line(std::size_t number) const { return end_[-1 - static_cast<std::ptrdiff_t>(number)]; }
    std::span<const FieldPoint> points(const BeamLine& line) const
    {
        return {points_ + line.first_point, line.points};
    }
    bool is_closed(const BeamLine& line) const
    {
        return line.points > 2 && points(line).front() == points(line).back();
    }

    /// The free memory, for adding lines: it is filled from both ends.
    std::span<std::byte> spare()
    {
        const std::size_t front = point_count_ * sizeof(FieldPoint);
        return {reinterpret_cast<std::byte*>(points_) + front, size_ - used_bytes()};
    }
    /// Whether something found no room: the picture is not complete.
    bool is_full() const { return is_full_; }
    std::size_t used_bytes() const
    {
        return point_count_ * sizeof(FieldPoint) + line_count_ * sizeof(BeamLine);
    }

private:
    bool has_capacity_for(std::size_t bytes);

    FieldPoint* points_ = nullptr;
    BeamLine* end_ = nullptr;
    std::size_t size_ = 0;
    std::size_t point_count_ = 0;
    std::size_t line_count_ = 0;
    BeamLine open_; ///< the one that is being added
    bool is_full_ = false;
};

static_assert(sizeof(FieldPoint) == 4 && sizeof(BeamLine) == 12);

/// One line of a route, and how it is followed.
struct BeamLeg {
    std::uint16_t line = 0;   ///< its number
    std::uint16_t start = 0;  ///< of a closed line: the number of its point where it begins and ends
    bool is_reversed = false; ///< from its last point to its first; never for a closed line

    friend constexpr bool operator==(const BeamLeg&, const BeamLeg&) = default;
};

/// Where the beam arrives on `leg`.
inline FieldPoint begin_of(const BeamLines& lines, const BeamLeg& leg)
{
    const std::span<const FieldPoint> points = lines.points(lines.line(leg.line));
    return leg.is_reversed ? points.back() : points[leg.start];
}

/// Where the beam leaves it.
inline FieldPoint end_of(const BeamLines& lines, const BeamLeg& leg)
{
    const std::span<const FieldPoint> points = lines.points(lines.line(leg.line));
    if (leg.is_reversed)
        return points.front();
    return leg.start == 0 ? points.back() : points[leg.start];
}

/// The leg in the other direction.
inline BeamLeg reversed(const BeamLines& lines, const BeamLeg& leg)
{
    const bool is_closed = lines.is_closed(lines.line(leg.line));
    return {leg.line, leg.start, !is_closed && !leg.is_reversed};
}

}
