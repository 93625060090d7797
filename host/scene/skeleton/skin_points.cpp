#include "host/scene/skeleton/skin_points.hpp"

namespace kfast::scene {

SkinPoints::SkinPoints(const Drawing& drawing)
{
    for (const Stroke& stroke : drawing.strokes)
        add(stroke);
}

std::vector<Binding> SkinPoints::bindings_of_all(const std::vector<Binding>& bindings) const
{
    std::vector<Binding> all;
    all.reserve(all_.size());
    for (const std::size_t index : all_)
        all.push_back(bindings[index]);
    return all;
}

void SkinPoints::add(const Stroke& stroke)
{
    const std::size_t first = spots_.size();
    add(stroke.from);
    for (const Segment& segment : stroke.segments)
        if (&segment == &stroke.segments.back() && segment.to == stroke.from)
            all_.push_back(first);
        else
            add(segment.to);
}

void SkinPoints::add(Point point)
{
    all_.push_back(spots_.size());
    spots_.push_back({point.x / 16.0, point.y / 16.0});
}

}
