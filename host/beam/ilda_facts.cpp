#include "host/beam/ilda_facts.hpp"

#include <algorithm>
#include <cmath>

namespace kfast {
namespace {

void stretch_to(IldaFacts& facts, FieldPoint at)
{
    facts.least = {std::min(facts.least.x, at.x), std::min(facts.least.y, at.y)};
    facts.most = {std::max(facts.most.x, at.x), std::max(facts.most.y, at.y)};
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
    facts.most_points = std::max(facts.most_points, frame.points.size());
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
    facts.least = facts.most = contents.frames.front().points.front().point.at;
    for (const IldaFrame& frame : contents.frames)
        add(facts, frame);
    return facts;
}

}
