#include "host/synfig/evaluation/time_values.hpp"

#include <algorithm>
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
    Value before = evaluator.link(node, "before", time);
    if (time <= moment - length || length <= 0)
        return before;
    const Value after = evaluator.link(node, "after", time);
    return sum(after, product(difference(before, after), (moment - time) / length));
}

/// By central differences over an interval, like the roughest of Synfig's.
Value derivative(Evaluator& evaluator, const ValueNode& node, double time)
{
    const double interval = std::max(1e-6, evaluator.number(node, "interval", time, 0.01));
    const auto at = [&](double moment) { return evaluator.link(node, "link", moment); };
    if (evaluator.number(node, "order", time, 0) == 0)
        return product(difference(at(time + interval / 2), at(time - interval / 2)), 1 / interval);
    const Value bend = sum(difference(at(time + interval), product(at(time), 2)), at(time - interval));
    return product(bend, 1 / (interval * interval));
}

}

ValueLaws time_laws()
{
    return {{"step", step}, {"timeloop", time_loop}, {"timed_swap", timed_swap}, {"derivative", derivative}};
}

}
