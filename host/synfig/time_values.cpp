#include "host/synfig/time_values.hpp"

#include <cmath>

namespace kfast::synfig {
namespace {

Value step(Evaluator& evaluator, const ValueNode& node, double time)
{
    const double duration = evaluator.number(node, "duration", time);
    const double start = evaluator.number(node, "start_time", time);
    if (duration == 0)
        return evaluator.link(node, "link", time);
    const double share = evaluator.number(node, "intersection", time);
    return evaluator.link(node, "link", (std::floor((time - start) / duration) + share) * duration + start);
}

Value time_loop(Evaluator& evaluator, const ValueNode& node, double time)
{
    const double duration = evaluator.number(node, "duration", time);
    const double from = evaluator.number(node, "link_time", time);
    if (duration == 0)
        return evaluator.link(node, "link", from);
    const double since = time - evaluator.number(node, "local_time", time);
    const double length = std::abs(duration);
    const double inside = since - std::floor(since / length) * length;
    return evaluator.link(node, "link", duration > 0 ? from + inside : from - inside);
}

Value timed_swap(Evaluator& evaluator, const ValueNode& node, double time)
{
    const double moment = evaluator.number(node, "time", time);
    const double length = evaluator.number(node, "length", time);
    if (time > moment)
        return evaluator.link(node, "after", time);
    const Value before = evaluator.link(node, "before", time);
    if (time <= moment - length || length <= 0)
        return before;
    const Value after = evaluator.link(node, "after", time);
    return sum(after, product(difference(before, after), (moment - time) / length));
}

}

ValueLaws time_laws() { return {{"step", step}, {"timeloop", time_loop}, {"timed_swap", timed_swap}}; }

}
