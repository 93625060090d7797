#include "host/beam/ilda_facts.hpp"

#include <algorithm>
#include <cmath>

namespace kfast {
namespace {

void stretch_to(IldaFacts& facts, FieldPoint at)
{
    facts.min = {std::min(facts.min.x, at.x), std::min(facts.min.y, at.y)};
    facts.max = {std::max(facts.max.x, at.x), std::max(facts.max.y, at.y)};
}

void add_step(IldaFacts& facts, FieldPoint from, const BeamPoint& to)
{
    double& longest = to.is_lit() ? facts.longest_lit_step : facts.longest_blanked_step;
    longest = std::max(longest, std::hypot(to.at.x - from.x, to.at.y - from.y));
}

void add(IldaFacts& facts, const IldaFrame& frame)
{
    facts.formats.insert(frame.format);
    facts.points += frame.points.size();
    facts.max_points = std::max(facts.max_points, frame.points.size());
    FieldPoint before = frame.points.front().point.at;
    for (const auto& [point, z] : frame.points) {
        facts.lit_points += point.is_lit();
        stretch_to(facts, point.at);
        add_step(facts, before, point);
        before = point.at;
    }
}

}

IldaFacts ilda_facts(const IldaContents& contents)
{
    IldaFacts facts;
    facts.min = facts.max = contents.frames.front().points.front().point.at;
    for (const IldaFrame& frame : contents.frames)
        add(facts, frame);
    return facts;
}

}
