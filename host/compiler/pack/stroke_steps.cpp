#include "host/compiler/pack/stroke_steps.hpp"

namespace kfast {
namespace {

Delta delta(scene::Point from, scene::Point to) { return {to.x - from.x, to.y - from.y}; }

Delta mirrored(Delta delta, bool x, bool y) { return {x ? -delta.x : delta.x, y ? -delta.y : delta.y}; }

}

Steps steps_of(const scene::Stroke& stroke)
{
    Steps steps;
    scene::Point at = stroke.from;
    for (const scene::Segment& segment : stroke.segments) {
        Step step{.cubic = segment.cubic, .end = delta(at, segment.to)};
        if (segment.cubic) {
            step.c1 = delta(at, segment.c1);
            step.back = delta(segment.to, segment.c2);
        }
        steps.push_back(step);
        at = segment.to;
    }
    return steps;
}

Steps mirrored(const Steps& steps, bool x, bool y)
{
    Steps other = steps;
    for (Step& step : other)
        for (Delta Step::*part : {&Step::end, &Step::c1, &Step::back})
            step.*part = mirrored(step.*part, x, y);
    return other;
}

}
