#include "core/pose/live_drawing.hpp"

#include <algorithm>

namespace kfast {
namespace {

static_assert(sizeof(LivePoint) == 4);

/// Of one drawing; a multiple of 4.
constexpr std::size_t bytes_of_strokes(std::size_t strokes) { return (strokes + 1) / 2 * 4; }

constexpr std::size_t bytes_of_drawing(std::size_t strokes, std::size_t points)
{
    return bytes_of_strokes(strokes) + points * sizeof(LivePoint);
}

}

std::size_t LiveDrawing::bytes_for(const DrawingInput& limits)
{
    return sizeof(Head) + 2 * bytes_of_drawing(limits.strokes, limits.points);
}

LiveDrawing::LiveDrawing(std::span<std::byte> memory, const DrawingInput& limits)
    : head_{reinterpret_cast<Head*>(memory.data())}, most_strokes_{limits.strokes}, most_points_{
                                                                                        limits.points}
{
}

std::uint16_t* LiveDrawing::ends(std::size_t drawing) const
{
    std::byte* const first = reinterpret_cast<std::byte*>(head_ + 1);
    return reinterpret_cast<std::uint16_t*>(first + drawing * bytes_of_drawing(most_strokes_, most_points_));
}

LivePoint* LiveDrawing::points(std::size_t drawing) const
{
    return reinterpret_cast<LivePoint*>(reinterpret_cast<std::byte*>(ends(drawing)) +
                                        bytes_of_strokes(most_strokes_));
}

LiveStroke LiveDrawing::stroke(std::uint32_t number) const
{
    const std::uint16_t* const ends_of_shown = ends(head_->shown);
    const std::size_t first = number == 0 ? 0 : ends_of_shown[number - 1];
    return {points(head_->shown) + first, ends_of_shown[number] - first};
}

void LiveDrawing::begin()
{
    next() = {};
    head_->has_stroke = 0;
    head_->mark = 0;
}

bool LiveDrawing::add(LivePoint point)
{
    Counts& counts = next();
    if (counts.points == most_points_ || (head_->has_stroke == 0 && counts.strokes == most_strokes_))
        return false;
    if (head_->has_stroke == 0)
        ++counts.strokes;
    head_->has_stroke = 1;
    points(next_number())[counts.points++] = point;
    ends(next_number())[counts.strokes - 1] = counts.points;
    return true;
}

bool LiveDrawing::show()
{
    const bool differs = !is_same();
    head_->shown = static_cast<std::uint16_t>(next_number());
    begin();
    return differs;
}

bool LiveDrawing::is_same() const
{
    const Counts& a = head_->drawings[0];
    const Counts& b = head_->drawings[1];
    return a.strokes == b.strokes && a.points == b.points &&
           std::equal(ends(0), ends(0) + a.strokes, ends(1)) &&
           std::equal(points(0), points(0) + a.points, points(1));
}

}
