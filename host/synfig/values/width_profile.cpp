#include "host/synfig/values/width_profile.hpp"

#include "host/art/animation/animated.hpp"

namespace kfast::synfig {

double width_at(const List& points, double position, double default_value)
{
    const WidthPoint* before = nullptr;
    const WidthPoint* behind = nullptr;
    for (const Value& entry : points.entries) {
        const WidthPoint* point = std::get_if<WidthPoint>(&entry.held);
        if (!point)
            continue;
        if (point->position <= position && (!before || point->position >= before->position))
            before = point;
        if (point->position >= position && (!behind || point->position < behind->position))
            behind = point;
    }
    if (!before || !behind)
        return before ? before->width : behind ? behind->width : default_value;
    const double span = behind->position - before->position;
    return span <= 0 ? before->width
                     : art::mixed(before->width, behind->width, (position - before->position) / span);
}

}
