#include "host/synfig/evaluation/evaluator.hpp"

#include "host/synfig/values/value_node.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <variant>

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

/// By central differences over an interval, like the coarsest of Synfig's.
Value derivative(Evaluator& evaluator, const ValueNode& node, double time)
{
    const double interval = std::max(1e-6, evaluator.number(node, "interval", time, 0.01));
    const auto at = [&](double moment) { return evaluator.link(node, "link", moment); };
    if (evaluator.number(node, "order", time, 0) == 0)
        return product(difference(at(time + interval / 2), at(time - interval / 2)), 1 / interval);
    const Value bend = sum(difference(at(time + interval), product(at(time), 2)), at(time - interval));
    return product(bend, 1 / (interval * interval));
}

/// The laws of values that go by another time.
ValueLaws time_laws()
{
    return {{"step", step}, {"timeloop", time_loop}, {"timed_swap", timed_swap}, {"derivative", derivative}};
}

constexpr int deepest = 400;
constexpr std::size_t max_steps = 30'000'000;

// Formulas reach any number; what no canvas needs is clamped, so that all further arithmetic stays finite.
constexpr double largest = 1e12;

double bounded(double value) { return std::isnan(value) ? 0 : std::clamp(value, -largest, largest); }

Value bounded(Value value)
{
    if (double* number = std::get_if<double>(&value.held))
        *number = bounded(*number);
    else if (Vec2* spot = std::get_if<Vec2>(&value.held))
        *spot = {bounded(spot->x), bounded(spot->y)};
    else if (Colour* colour = std::get_if<Colour>(&value.held))
        *colour = {bounded(colour->red), bounded(colour->green), bounded(colour->blue),
                   bounded(colour->alpha)};
    return value;
}

Value constant(Evaluator&, const ValueNode& node, double) { return node.constant; }

Value animated(Evaluator& evaluator, const ValueNode& node, double time)
{
    const auto& points = node.waypoints;
    const auto next = std::ranges::upper_bound(points, time, {}, &Waypoint::time);
    if (next == points.begin() || points.size() == 1)
        return evaluator.at(*points.front().value, time);
    const Waypoint& from = *std::prev(next);
    if (next == points.end())
        return evaluator.at(*from.value, time);
    const bool plain = from.value->kind == "constant" && next->value->kind == "constant";
    Value here = evaluator.at(*from.value, time);
    if (!goes_smoothly(here) || from.after == Interpolation::constant ||
        next->before == Interpolation::constant)
        return here;
    Value result;
    if (plain) {
        result = value_on_way(points, static_cast<std::size_t>(std::prev(next) - points.begin()), time);
    } else {
        const double share = warped_share(from, *next, (time - from.time) / (next->time - from.time));
        result = sum(here, product(difference(evaluator.at(*next->value, time), here), share));
    }
    return node.type == "integer" ? rounded(result) : result;
}

}

Evaluator::Law Evaluator::law_of(std::string_view kind)
{
    static const std::map<std::string_view, Law> laws = [] {
        std::map<std::string_view, Law> all{{"constant", constant}, {"animated", animated}};
        for (const auto& family :
             {arithmetic_laws(), composite_laws(), time_laws(), spline_laws(), bone_laws(), list_laws()})
            all.insert(family.begin(), family.end());
        return all;
    }();
    const auto found = laws.find(kind);
    return found == laws.end() ? nullptr : found->second;
}

bool Evaluator::knows(std::string_view kind)
{
    return law_of(kind) && kind != "random" && kind != "duplicate";
}

Value Evaluator::at(const ValueNode& node, double time)
{
    if (++steps_ > max_steps)
        file_.fail(node.place,
                   "working out the values of this file takes too long: make it shorter or simpler");
    if (node.kind == "constant")
        return node.constant;
    const Law law = law_of(node.kind);
    if (!law)
        return {};
    if (++depth_ > deepest)
        file_.fail(node.place, "this value depends on itself, or on too many others one after the other");
    Value value = bounded(law(*this, node, time));
    --depth_;
    return value;
}

Bone Evaluator::bone(const std::string& guid, double time)
{
    const ValueNodePtr node = guid.empty() ? nullptr : reader_.bone(guid);
    if (!node)
        return {};
    for (const std::string& kind : node->unknown)
        losses_.add({"value <" + kind + "> of a bone", "", {}, instead_of_value});
    return at(*node, time).as<Bone>();
}

Value Evaluator::link(const ValueNode& node, std::string_view name, double time)
{
    const ValueNode* linked = node.link(name);
    return linked ? at(*linked, time) : Value{};
}

double Evaluator::number(const ValueNode& node, std::string_view name, double time, double default_value)
{
    return link(node, name, time).number(default_value);
}

bool Evaluator::truth(const ValueNode& node, std::string_view name, double time, bool default_value)
{
    return link(node, name, time).truth(default_value);
}

Vec2 Evaluator::spot(const ValueNode& node, std::string_view name, double time)
{
    return link(node, name, time).as<Vec2>();
}

}
