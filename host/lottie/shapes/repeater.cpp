#include "host/lottie/shapes/shapes.hpp"

#include "host/art/geometry/affine.hpp"
#include "host/lottie/values/channel.hpp"
#include "host/lottie/values/json.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
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

/// The opacities of the lowest copy and the next one, of which the first is 1.
std::optional<double> opacity_step(const Repeater& repeater, double first, double last, double count)
{
    const double lowest = repeater.first_on_top ? last : first;
    const double highest = repeater.first_on_top ? first : last;
    if (lowest != 1 || !(highest >= 0 && highest <= 1))
        return std::nullopt;
    return (highest - lowest) / (count - 1);
}

/// Numbers of a repeater that stand still.
struct Steps {
    double offset = 0;
    scene::Vec2 anchor = {};
    scene::Vec2 move = {};
    double scale = 1;
    double rotation = 0;
};

std::optional<Steps> steps_of(const Repeater& repeater)
{
    const art::Transform& step = repeater.step;
    const auto numbers = {&repeater.offset, &step.anchor_x, &step.anchor_y, &step.x,
                          &step.y,          &step.scale_x,  &step.rotate};
    if (!std::ranges::all_of(numbers, [](const Channel* channel) { return channel->is_still(); }) ||
        step.scale_x != step.scale_y)
        return std::nullopt;
    return Steps{repeater.offset.value(),
                 {step.anchor_x.value(), step.anchor_y.value()},
                 {step.x.value(), step.y.value()},
                 step.scale_x.value(),
                 step.rotate.value()};
}

/// All copies as one use of a symbol: each is then the one below it, once more moved, turned and scaled. Null
/// if that is not the same picture.
std::shared_ptr<const CopySet> copy_set(const Repeater& repeater, double count)
{
    constexpr double fewest = 3;
    constexpr double largest_growth = 16; // of one copy relative to another: finer is not stored
    const auto steps = steps_of(repeater);
    if (!repeater.copies.is_still() || !repeater.first_opacity.is_still() ||
        !repeater.last_opacity.is_still() || !steps || !(count >= fewest && count <= art::Copies::max) ||
        !(steps->scale > 0))
        return nullptr;
    const auto fade =
        opacity_step(repeater, repeater.first_opacity.value(), repeater.last_opacity.value(), count);
    const double growth = std::pow(steps->scale, count - 1);
    // Powers of fractions below 0 are no steps.
    if (!fade || !(growth <= largest_growth && growth >= 1 / largest_growth) ||
        (steps->offset < 0 && steps->scale != 1))
        return nullptr;
    const double lowest = steps->offset + (repeater.first_on_top ? count - 1 : 0);
    const double direction = repeater.first_on_top ? -1 : 1;
    CopySet set;
    set.place.x = {steps->anchor.x + lowest * steps->move.x};
    set.place.y = {steps->anchor.y + lowest * steps->move.y};
    set.place.rotate = {lowest * steps->rotation};
    set.content.anchor_x = {steps->anchor.x};
    set.content.anchor_y = {steps->anchor.y};
    set.content.scale_x = set.content.scale_y = {power(steps->scale, lowest)};
    const scene::Vec2 move = art::turned(-lowest * steps->rotation).of(direction * steps->move);
    set.copies = {
        static_cast<int>(count),           move.x, move.y, std::fmod(direction * steps->rotation, 360),
        std::pow(steps->scale, direction), *fade};
    return std::make_shared<const CopySet>(set);
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

void part_copies(std::vector<ShapeItem>& items)
{
    for (ShapeItem& item : items)
        if (auto* group = std::get_if<GroupItem>(&item.content)) {
            group->copies.reset();
            part_copies(group->items);
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
    if (const auto set = copy_set(repeater, count))
        for (ShapeItem& each : copies) {
            auto& group = std::get<GroupItem>(each.content);
            group.copies = set;
            group.is_first_copy = &each == &copies.front();
        }
    if (!repeater.first_on_top)
        std::ranges::reverse(copies);
    return copies;
}

}
