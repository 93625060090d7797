#include "host/compiler/match/even_stroke.hpp"

namespace kfast {
namespace {

constexpr double tolerance = 1.0 / 32;
constexpr double shortest_divided = 2;

void append(MeasuredStroke& stroke, const MeasuredSegment& segment)
{
    if (segment.length < shortest_divided || unevenness(segment) <= tolerance) {
        stroke.push_back(segment);
        return;
    }
    append(stroke, stretch(segment, 0, 0.5));
    append(stroke, stretch(segment, 0.5, 1));
}

}

MeasuredStroke made_even(const MeasuredStroke& stroke)
{
    MeasuredStroke even;
    for (const MeasuredSegment& segment : stroke)
        append(even, segment);
    return even;
}

}
