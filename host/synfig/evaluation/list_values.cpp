#include "host/synfig/evaluation/list_values.hpp"

#include "host/art/animation/animated.hpp"
#include "host/synfig/evaluation/spline_list.hpp"
#include "host/synfig/values/presence.hpp"
#include "host/synfig/values/width_profile.hpp"

namespace kfast::synfig {
namespace {

List present_entries(Evaluator& evaluator, const ValueNode& node, double time)
{
    List list{{}, node.loop};
    for (const Entry& entry : node.entries)
        if (presence_at(entry, time).amount > 0)
            list.entries.push_back(evaluator.at(*entry.value, time));
    return list;
}

Value list(Evaluator& evaluator, const ValueNode& node, double time)
{
    return {present_entries(evaluator, node, time)};
}

Value spline(Evaluator& evaluator, const ValueNode& node, double time)
{
    return {spline_list(evaluator, node, time)};
}

Value average(Evaluator& evaluator, const ValueNode& node, double time)
{
    const List list = present_entries(evaluator, node, time);
    if (list.entries.empty())
        return {};
    Value total = list.entries.front();
    for (std::size_t i = 1; i < list.entries.size(); ++i)
        total = sum(total, list.entries[i]);
    return product(total, 1.0 / static_cast<double>(list.entries.size()));
}

Value weighted_average(Evaluator& evaluator, const ValueNode& node, double time)
{
    Value total;
    double weights = 0;
    for (const Value& entry : present_entries(evaluator, node, time).entries) {
        const auto parts = entry.as<List>().entries;
        if (parts.size() != 2)
            continue;
        const Value part = product(parts[1], parts[0].number());
        total = std::holds_alternative<std::monostate>(total.held) ? part : sum(total, part);
        weights += parts[0].number();
    }
    return weights == 0 ? total : product(total, 1 / weights);
}

/// A width point that comes or goes grows out of the line as it is without it.
Value width_points(Evaluator& evaluator, const ValueNode& node, double time)
{
    List settled{{}, node.loop};
    List all{{}, node.loop};
    for (const Entry& entry : node.entries)
        if (presence_at(entry, time).amount == 1)
            settled.entries.push_back(evaluator.at(*entry.value, time));
    for (const Entry& entry : node.entries) {
        const double amount = presence_at(entry, time).amount;
        WidthPoint point = evaluator.at(*entry.value, time).as<WidthPoint>();
        if (amount < 1)
            point.width = art::mixed(width_at(settled, point.position, point.width), point.width, amount);
        if (amount > 0)
            all.entries.push_back({point});
    }
    return {std::move(all)};
}

}

ValueLaws list_laws()
{
    return {{"static_list", list},
            {"dynamic_list", list},
            {"bline", spline},
            {"wplist", width_points},
            {"dilist", list},
            {"average", average},
            {"weighted_average", weighted_average}};
}

}
