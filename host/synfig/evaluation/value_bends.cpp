#include "host/synfig/evaluation/value_bends.hpp"

#include "host/program/failure.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace kfast::synfig {
namespace {

constexpr std::size_t max_repeats = 10'000;
constexpr int deepest = 1200; ///< nested values, chains of bones included

double constant(const ValueNode& node, std::string_view name)
{
    const ValueNode* link = node.link(name);
    return link ? link->constant.number() : 0;
}

}

void ValueBends::add(const ValueNode& node)
{
    if (!seen_.insert(&node).second)
        return;
    if (++depth_ > deepest)
        throw Failure("more than " + std::to_string(deepest) +
                      " values are made of each other: take bones out of the skeleton");
    add_new(node);
    --depth_;
}

void ValueBends::add_new(const ValueNode& node)
{
    if (const BoneName* name = std::get_if<BoneName>(&node.constant.held); name && node.kind == "constant")
        if (const ValueNodePtr bone = reader_.bone(name->guid))
            add(*bone);
    for (const Waypoint& point : node.waypoints) {
        times_.insert(point.time);
        add(*point.value);
    }
    for (const Entry& entry : node.entries) {
        for (const Switching& switching : entry.switchings)
            times_.insert(switching.time);
        add(*entry.value);
    }
    if (node.kind == "step" || node.kind == "timeloop")
        add_repeats(node);
    if (node.kind == "timed_swap") {
        times_.insert(constant(node, "time"));
        times_.insert(constant(node, "time") - constant(node, "length"));
    }
    add_links(node);
}

void ValueBends::add_links(const ValueNode& node)
{
    for (const auto& [name, link] : node.links)
        add(*link);
}

void ValueBends::add_repeats(const ValueNode& node)
{
    const double length = std::abs(constant(node, "duration"));
    const double start = constant(node, node.kind == "step" ? "start_time" : "local_time");
    if (length <= 0 || (to_ - from_) / length > max_repeats)
        return;
    ValueBends inner{reader_, from_, to_};
    inner.add_links(node);
    std::vector<double> offsets{0};
    if (node.kind == "timeloop")
        for (const double time : inner.times())
            offsets.push_back(std::fmod(std::abs(time - constant(node, "link_time")), length));
    const double first = start + std::floor((from_ - start) / length) * length;
    for (int turn = 0; first + turn * length <= to_ && times_.size() < max_repeats; ++turn)
        for (const double offset : offsets)
            times_.insert(first + turn * length + offset);
}

}
