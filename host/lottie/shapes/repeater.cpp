#include "host/lottie/shapes/shapes.hpp"

#include "host/lottie/values/channel.hpp"
#include "host/lottie/values/json.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace kfast::lottie {
namespace {

using art::Channel;

/// A number to the power of a count that need not be whole: the fraction is interpolated
/// linearly. What becomes too large, as the inverse of 0 does, is clamped to what can be
/// drawn.
double power(double base, double count)
{
    constexpr double largest = 1e6;
    const double whole = std::trunc(count);
    const double rest = 1 + (base - 1) * std::abs(count - whole);
    const double grown = std::pow(base, std::abs(whole)) * rest;
    const double result = count < 0 ? 1 / grown : grown;
    return std::isfinite(result) ? std::clamp(result, -largest, largest) : largest;
}

struct Repeater {
    Channel copies;
    Channel offset;
    art::Transform step; ///< from one copy to the next
    Channel first_opacity;
    Channel last_opacity;
    bool first_on_top = true;
};

Repeater read_repeater(const Json& item, const Reading& reading)
{
    static const Json none = Json::object();
    const Json* const found = find_member(item, "tr");
    const Json& step = found ? *found : none;
    const auto channel = [&](const Json& owner, const char* name, double default_value, double factor) {
        return read_channel(owner, name, 0, default_value, factor, reading.time, reading.budget);
    };
    return {channel(item, "c", 1, 1),     channel(item, "o", 0, 1),     read_transform(step, reading),
            channel(step, "so", 1, 0.01), channel(step, "eo", 1, 0.01), whole_at(item, "m", 1) == 1};
}

/// The number of copies, rounded up.
double copies_at(const Channel& copies, double time)
{
    return std::max(0.0, std::ceil(copies.at(time) - 1e-6));
}

/// The maximum number of copies; an overshoot beyond the keys is not shown.
double max_copies(const Channel& copies)
{
    double max = 0;
    for (const auto& key : copies.keys)
        max = std::max(max, copies_at(copies, key.time));
    return max;
}

/// When there are more copies than `index`.
std::vector<art::Span> shown(const Channel& copies, double index, art::Budget& budget)
{
    if (copies.is_still())
        return {{}};
    constexpr int max_looks = 4096;
    budget.take_computed_points(max_looks);
    const auto is_there = [&](double time) { return copies_at(copies, time) > index; };
    std::vector<art::Span> spans;
    const double begin = copies.keys.front().time;
    const double end = copies.keys.back().time;
    bool there = is_there(begin);
    if (there)
        spans.push_back({});
    const double step = std::max(0.25, (end - begin) / max_looks);
    for (double from = begin; from < end; from += step) {
        double before = from;
        double after = std::min(from + step, end);
        if (is_there(after) == there)
            continue;
        while (after - before > 1.0 / 1024) {
            const double middle = (before + after) / 2;
            if (!(before < middle && middle < after))
                break; // such large times have no finer steps
            (is_there(middle) == there ? before : after) = middle;
        }
        there = !there;
        if (there)
            spans.push_back({.from = after});
        else
            spans.back().to = after;
    }
    return spans;
}

Channel opacity(const Repeater& repeater, double index, art::Budget& budget)
{
    const auto at = [&](double time) {
        const double first = repeater.first_opacity.at(time);
        const double count = copies_at(repeater.copies, time);
        return count < 2
                   ? first
                   : first + (repeater.last_opacity.at(time) - first) * std::min(1.0, index / (count - 1));
    };
    return combined(at, {&repeater.first_opacity, &repeater.last_opacity}, Dependence::linear, 1.0 / 1024,
                    budget);
}

/// The step of a copy: rotated about the anchor, scaled about it, and moved.
struct CopyStep {
    art::Transform move_and_grow;
    std::optional<art::Transform> rotation; ///< a separate one, where the scales differ
};

CopyStep step_of(const Repeater& repeater, double index, art::Budget& budget)
{
    const art::Transform& step = repeater.step;
    const Channel& offset = repeater.offset;
    constexpr double fine = 1.0 / 256;
    constexpr double fine_scale = 1.0 / 8192;
    const auto moved = [&](const Channel& anchor, const Channel& way) {
        return combined(
            [&](double time) { return anchor.at(time) + (index + offset.at(time)) * way.at(time); },
            {&anchor, &way, &offset}, Dependence::linear, fine, budget);
    };
    const auto grown = [&](const Channel& scale) {
        return combined([&](double time) { return power(scale.at(time), index + offset.at(time)); },
                        {&scale, &offset}, Dependence::curved, fine_scale, budget);
    };
    CopyStep result;
    art::Transform& outer = result.move_and_grow;
    outer.anchor_x = step.anchor_x;
    outer.anchor_y = step.anchor_y;
    outer.x = moved(step.anchor_x, step.x);
    outer.y = moved(step.anchor_y, step.y);
    outer.scale_x = grown(step.scale_x);
    outer.scale_y = grown(step.scale_y);
    const Channel turned =
        combined([&](double time) { return (index + offset.at(time)) * step.rotate.at(time); },
                 {&step.rotate, &offset}, Dependence::linear, fine, budget);
    const bool is_turned = turned != Channel{0};
    if (is_turned && step.scale_x != step.scale_y) {
        result.rotation.emplace();
        result.rotation->anchor_x = result.rotation->x = step.anchor_x;
        result.rotation->anchor_y = result.rotation->y = step.anchor_y;
        result.rotation->rotate = turned;
    } else {
        outer.rotate = turned;
    }
    return result;
}

ShapeItem copy(const std::vector<ShapeItem>& items, const Repeater& repeater, double index,
               art::Budget& budget)
{
    CopyStep step = step_of(repeater, index, budget);
    GroupItem group;
    group.items = items;
    if (step.rotation) {
        GroupItem inner = std::move(group);
        inner.transform = std::move(*step.rotation);
        group = {};
        group.items.push_back({std::move(inner)});
    }
    group.transform = std::move(step.move_and_grow);
    group.opacity = opacity(repeater, index, budget);
    group.shown = shown(repeater.copies, index, budget);
    return {std::move(group)};
}

void take_nodes(const std::vector<ShapeItem>& items, art::Budget& budget)
{
    for (const ShapeItem& item : items) {
        budget.take_node();
        if (const auto* group = std::get_if<GroupItem>(&item.content))
            take_nodes(group->items, budget);
    }
}

void report_what_is_not_repeated(const Repeater& repeater, const Reading& reading)
{
    if (repeater.step.skew != Channel{0})
        reading.losses.add({"skew of a repeater", reading.layer, std::nullopt, "copies that do not lean"});
    if (repeater.step.path)
        reading.losses.add(
            {"curved motion of a repeater", reading.layer, std::nullopt, "copies in one place"});
}

}

std::vector<ShapeItem> repeated(const std::vector<ShapeItem>& items, const Json& item, const Reading& reading)
{
    if (items.empty())
        return {};
    const Repeater repeater = read_repeater(item, reading);
    report_what_is_not_repeated(repeater, reading);
    const double count = max_copies(repeater.copies);
    std::vector<ShapeItem> copies;
    for (double index = 0; index < count; ++index) {
        take_nodes(items, reading.budget);
        copies.push_back(copy(items, repeater, index, reading.budget));
    }
    if (!repeater.first_on_top)
        std::ranges::reverse(copies);
    return copies;
}

}
