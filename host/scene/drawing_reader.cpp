#include "host/scene/drawing_reader.hpp"

#include "host/scene/limits.hpp"
#include "host/scene/shape_reader.hpp"

namespace kfast::scene {

void DrawingReader::read(const kdl::Node& node)
{
    for (const Outline& outline : read_shape(node, most_points - points_, reading_))
        if (!add(outline, node))
            return;
}

bool DrawingReader::add(const Outline& outline, const kdl::Node& node)
{
    if (!in_range(outline))
        return reading_.report.error(node.name_place,
                                     "this " + node.name + " reaches more than 2047 px from the origin");
    Stroke stroke = quantized(outline);
    const std::size_t points = stroke.segments.size() + 1;
    if (points > most_points - points_)
        return reading_.report.error(node.name_place, too_many_points());
    points_ += points;
    drawing_.strokes.push_back(std::move(stroke));
    return true;
}

}
