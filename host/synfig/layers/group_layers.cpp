#include "host/synfig/layers/group_layers.hpp"

#include "host/art/geometry/affine.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

namespace kfast::synfig {
namespace {

using Numbers = std::function<double(double)>;
using Spots = std::function<Vec2(double)>;

/// Traces what depends on some parameters of a layer.
class Channels {
public:
    Channels(const Layer& layer, std::vector<std::string_view> names)
        : layer_{layer}, names_{std::move(names)}
    {
    }

    art::Channel operator()(const Numbers& value, double tolerance) const
    {
        return traced(value, layer_.tracing(names_, tolerance));
    }

private:
    const Layer& layer_;
    std::vector<std::string_view> names_;
};

/// Sets x and y from a point in units of the file.
void set_place(const Channels& channels, const art::Affine& to_canvas, const Spots& place, art::Channel& x,
               art::Channel& y)
{
    x = channels([&](double frame) { return to_canvas.of(place(frame)).x; }, place_tolerance);
    y = channels([&](double frame) { return to_canvas.of(place(frame)).y; }, place_tolerance);
}

Placement placement_at(const Layer& group, double frame)
{
    return group.at("transformation", frame).as<Placement>();
}

/// Groups of files before 0.64 have an origin, a focus and a zoom instead of a transformation.
bool is_old(const Layer& group)
{
    return !group.has("transformation") &&
           (group.version() == "0.1" || group.has("focus") || group.has("zoom"));
}

/// The angle nearest to the one of the frame before, so that it never jumps by a turn.
Numbers unwound(Numbers angle, double frames)
{
    struct Known {
        std::vector<double> turns;
    };
    auto known = std::make_shared<Known>();
    double last = angle(0);
    const int steps = static_cast<int>(std::min(frames, 100'000.0)) * 2;
    for (int i = 0; i <= steps; ++i) {
        const double here = angle(i / 2.0);
        last += std::remainder(here - last, 360);
        known->turns.push_back(last);
    }
    return [angle, known](double frame) {
        const double index = std::clamp(frame * 2, 0.0, static_cast<double>(known->turns.size() - 1));
        const double near = known->turns[static_cast<std::size_t>(index)];
        return near + std::remainder(angle(frame) - near, 360);
    };
}

void set_growth(const Layer& group, const Channels& channels, art::Transform& transform)
{
    const bool is_skewed = [&] {
        for (const auto& time : group.bends({"transformation"}))
            if (std::abs(std::remainder(placement_at(group, time).skew, 360)) > 1e-6)
                return true;
        return std::abs(std::remainder(placement_at(group, 0).skew, 360)) > 1e-6;
    }();
    transform.scale_x =
        channels([&](double frame) { return placement_at(group, frame).scale.x; }, scale_tolerance);
    transform.scale_y = channels(
        [&](double frame) {
            const Placement placement = placement_at(group, frame);
            return is_skewed ? placement.scale.y * std::cos(art::degree * placement.skew) : placement.scale.y;
        },
        scale_tolerance);
    if (is_skewed)
        // There the second axis is skewed; here the scale along the first axis follows the skew.
        transform.skew = channels(
            [&](double frame) {
                const Placement placement = placement_at(group, frame);
                return std::atan2(-placement.scale.y * std::sin(art::degree * placement.skew),
                                  placement.scale.x) /
                       art::degree;
            },
            angle_tolerance);
}

}

bool is_group(const Layer& layer)
{
    return layer.type() == "group" || layer.type() == "PasteCanvas" || layer.type() == "paste_canvas" ||
           layer.type() == "switch";
}

art::Transform placement_of(const Layer& group)
{
    const art::Affine& to_canvas = group.reading().to_canvas;
    const Channels channels{group, {"transformation", "origin", "focus", "zoom"}};
    art::Transform transform;
    if (is_old(group)) {
        const Spots focus = [&](double frame) { return group.spot("focus", frame); };
        set_place(channels, to_canvas, focus, transform.anchor_x, transform.anchor_y);
        set_place(
            channels, to_canvas, [&](double frame) { return focus(frame) + group.spot("origin", frame); },
            transform.x, transform.y);
        transform.scale_x =
            channels([&](double frame) { return std::exp(group.number("zoom", frame, 0)); }, scale_tolerance);
        transform.scale_y = transform.scale_x;
        return transform;
    }
    const Channels anchor{group, {"origin"}};
    set_place(
        anchor, to_canvas, [&](double frame) { return group.spot("origin", frame); }, transform.anchor_x,
        transform.anchor_y);
    const Channels own{group, {"transformation"}};
    set_place(
        own, to_canvas, [&](double frame) { return placement_at(group, frame).offset; }, transform.x,
        transform.y);
    const Numbers angle = [&](double frame) { return -placement_at(group, frame).angle; };
    const ValueNode* node = group.parameter("transformation");
    const bool may_wind = node && node->kind != "composite" && node->kind != "constant";
    transform.rotate = own(may_wind ? unwound(angle, group.reading().frames) : angle, angle_tolerance);
    set_growth(group, own, transform);
    return transform;
}

Scope inside_of(const Layer& group)
{
    Scope scope = group.scope();
    scope.path = group.path();
    ++scope.depth;
    // Both are called long after this: they keep the layer alive.
    const auto kept = std::make_shared<Layer>(group);
    if (group.has("time_offset") || group.has("time_dilation")) {
        const Driver clock = group.scope().clock;
        const auto at = [kept](std::string_view name, double seconds, double default_value) {
            const ValueNode* node = kept->parameter(name);
            return node ? kept->reading().evaluator.at(*node, seconds).number(default_value) : default_value;
        };
        scope.clock =
            clock.with(running_gear([at](double seconds) { return at("time_dilation", seconds, 1); },
                                    [at](double seconds) { return at("time_offset", seconds, 0); }));
    }
    if (group.has("outline_grow")) {
        const auto outer = scope.line_scale_factor;
        scope.line_scale_factor = [kept, outer](double frame) {
            return (outer ? outer(frame) : 1) * std::exp(kept->number("outline_grow", frame, 0));
        };
    }
    return scope;
}

std::optional<art::Transform> movement_of(const Layer& layer)
{
    const art::Affine& to_canvas = layer.reading().to_canvas;
    art::Transform transform;
    const auto about = [&](const char* name) {
        const Channels channels{layer, {name}};
        set_place(
            channels, to_canvas, [&](double frame) { return layer.spot(name, frame); }, transform.anchor_x,
            transform.anchor_y);
        transform.x = transform.anchor_x;
        transform.y = transform.anchor_y;
    };
    const Channels amount{layer, {"amount"}};
    if (layer.type() == "translate") {
        const Channels channels{layer, {"origin"}};
        const double pixels = layer.reading().pixels_per_unit;
        transform.x =
            channels([&](double frame) { return pixels * layer.spot("origin", frame).x; }, place_tolerance);
        transform.y =
            channels([&](double frame) { return -pixels * layer.spot("origin", frame).y; }, place_tolerance);
    } else if (layer.type() == "rotate") {
        about("origin");
        transform.rotate =
            amount([&](double frame) { return -layer.number("amount", frame, 0); }, angle_tolerance);
    } else if (layer.type() == "zoom") {
        about("center");
        transform.scale_x =
            amount([&](double frame) { return std::exp(layer.number("amount", frame, 0)); }, scale_tolerance);
        transform.scale_y = transform.scale_x;
    } else if (layer.type() == "stretch") {
        about("center");
        transform.scale_x = amount(
            [&](double frame) {
                return layer.spot("amount", frame, {1, 1}).x;
            },
            scale_tolerance);
        transform.scale_y = amount(
            [&](double frame) {
                return layer.spot("amount", frame, {1, 1}).y;
            },
            scale_tolerance);
    } else {
        return {};
    }
    return transform;
}

std::optional<Driver::Gear> gear_of(const Layer& layer)
{
    if (layer.type() == "freetime") {
        const auto kept = std::make_shared<Layer>(layer);
        return free_gear([kept](double seconds) {
            const ValueNode* node = kept->parameter("time");
            return node ? kept->reading().evaluator.at(*node, seconds).number() : 0;
        });
    }
    if (layer.type() != "timeloop")
        return {};
    const bool old = layer.has("start_time") || layer.has("end_time");
    const double local = layer.number(old ? "start_time" : "local_time", 0, 0);
    const double duration = old ? layer.number("end_time", 0, 1) - local : layer.number("duration", 0, 1);
    const bool only_forward = old || layer.truth("only_for_positive_duration", 0, false);
    if (only_forward && duration <= 0)
        return running_gear([](double) { return 1.0; }, [](double) { return 0.0; });
    const double inside = old ? 0 : layer.number("link_time", 0, 0);
    if (duration == 0)
        return running_gear([](double) { return 0.0; }, [inside](double) { return inside; });
    const bool symmetrical = !old && layer.truth("symmetrical", 0, true);
    return looping_gear(inside, local, duration, symmetrical ? 0 : -duration);
}

std::vector<art::Span> shown_by_switch(const Layer& choice, const std::string& name, std::size_t depth)
{
    const auto shown = [&](double frame) {
        const std::string wanted = choice.at("layer_name", frame).as<std::string>();
        return wanted.empty() ? choice.number("layer_depth", frame, -1) == static_cast<double>(depth)
                              : wanted == name;
    };
    std::vector<double> times = choice.bends({"layer_name", "layer_depth"});
    times.push_back(0);
    std::ranges::sort(times);
    std::vector<art::Span> spans;
    for (const double time : times) {
        const bool open = !spans.empty() && !std::isfinite(spans.back().to);
        if (shown(time) && !open)
            spans.push_back({time == 0 ? art::Span{}.from : time, art::Span{}.to});
        else if (!shown(time) && open)
            spans.back().to = time;
    }
    return spans;
}

}
