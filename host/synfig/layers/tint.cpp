#include "host/synfig/layers/tint.hpp"

#include "host/synfig/layers/cover_layers.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <variant>

namespace kfast::synfig {

void Tint::apply(std::vector<art::Node>& nodes) const
{
    for (art::Node& node : nodes) {
        if (auto* group = std::get_if<art::Group>(&node.content)) {
            apply(group->nodes);
            continue;
        }
        auto& shape = std::get<art::Shape>(node.content);
        if (shape.fill)
            apply(shape.fill->colour);
        if (shape.stroke)
            apply(shape.stroke->colour);
    }
}

void Tint::apply(art::Animated<art::Rgb>& colour) const
{
    std::vector<double> times = layer_.bends({"amount", "color", "gradient"});
    if (group_)
        std::ranges::copy(group_->bends({"amount"}), std::back_inserter(times));
    if (times.empty()) {
        for (auto& key : colour.keys)
            key.value = applied(key.value, 0);
        return;
    }
    for (const auto& key : colour.keys)
        times.push_back(key.time);
    const std::function<art::Rgb(double)> tinted = [&](double frame) {
        return applied(colour.at(frame), frame);
    };
    const Reading& reading = layer_.reading();
    colour = traced(tinted, Tracing{0, reading.frames, std::move(times), colour_tolerance, &reading.budget});
}

art::Rgb Tint::applied(const art::Rgb& below, double frame) const
{
    return layer_.rgb(tinting_(layer_.colour(below), colour_at(layer_, frame), amount(frame)));
}

double Tint::amount(double frame) const
{
    return layer_.number("amount", frame, 1) * (group_ ? group_->number("amount", frame, 1) : 1);
}

}
