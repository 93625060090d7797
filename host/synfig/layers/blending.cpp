#include "host/synfig/layers/blending.hpp"

#include "host/synfig/layers/cover_layers.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <string>
#include <variant>

namespace kfast::synfig {

namespace {

// The numbers that files have for them.
constexpr int composite = 0;
constexpr int straight = 1;
constexpr int behind = 12;
constexpr int straight_onto = 21;

template <typename Law>
Colour by_channels(const Colour& below, const Colour& above, Law law)
{
    return {law(below.red, above.red), law(below.green, above.green), law(below.blue, above.blue),
            below.alpha};
}

/// Blends one colour over another by law(), weighted by its opacity.
template <typename Law>
Colour laid_on(const Colour& below, const Colour& above, double amount, Law law)
{
    const double share = amount * above.alpha;
    return by_channels(below, above,
                       [&](double under, double over) { return under + share * (law(under, over) - under); });
}

Colour onto(const Colour& below, const Colour& above, double amount)
{
    return laid_on(below, above, amount, [](double, double over) { return over; });
}

Colour brighten(const Colour& below, const Colour& above, double amount)
{
    const double share = amount * above.alpha;
    return by_channels(below, above,
                       [&](double under, double over) { return std::max(under, over * share); });
}

Colour darken(const Colour& below, const Colour& above, double amount)
{
    const double share = amount * above.alpha;
    return by_channels(below, above,
                       [&](double under, double over) { return std::min(under, (over - 1) * share + 1); });
}

Colour add(const Colour& below, const Colour& above, double amount)
{
    const double share = amount * above.alpha;
    return by_channels(below, above, [&](double under, double over) { return under + over * share; });
}

Colour subtract(const Colour& below, const Colour& above, double amount)
{
    return add(below, above, -amount);
}

Colour multiply(const Colour& below, const Colour& above, double amount)
{
    return laid_on(below, above, amount, [](double under, double over) { return under * over; });
}

Colour divide(const Colour& below, const Colour& above, double amount)
{
    constexpr double min = 1e-6;
    return laid_on(below, above, amount, [](double under, double over) { return under / (over + min); });
}

Colour screen(const Colour& below, const Colour& above, double amount)
{
    return laid_on(below, above, amount,
                   [](double under, double over) { return 1 - (1 - under) * (1 - over); });
}

Colour hard_light(const Colour& below, const Colour& above, double amount)
{
    return laid_on(below, above, amount, [](double under, double over) {
        return over > 0.5 ? 1 - (2 - 2 * over) * (1 - under) : 2 * over * under;
    });
}

Colour difference_of(const Colour& below, const Colour& above, double amount)
{
    const double share = amount * above.alpha;
    return by_channels(below, above,
                       [&](double under, double over) { return std::abs(under - over * share); });
}

Colour overlay(const Colour& below, const Colour& above, double amount)
{
    return laid_on(below, above, amount, [](double under, double over) {
        return under * (1 - (1 - under) * (1 - over)) + (1 - under) * under * over;
    });
}

struct Method {
    const char* name;
    Tinting tinting = nullptr;
    /// Tinting overlapping shapes one by one is the same as tinting them together.
    bool is_exact = false;
};

const std::map<int, Method>& methods()
{
    static const std::map<int, Method> all{{straight, {"straight"}},
                                           {2, {"brighten", brighten}},
                                           {3, {"darken", darken}},
                                           {4, {"add", add}},
                                           {5, {"subtract", subtract}},
                                           {6, {"multiply", multiply, true}},
                                           {7, {"divide", divide}},
                                           {8, {"colour"}},
                                           {9, {"hue"}},
                                           {10, {"saturation"}},
                                           {11, {"luminance"}},
                                           {13, {"onto", onto, true}},
                                           {14, {"alpha brighten"}},
                                           {15, {"alpha darken"}},
                                           {16, {"screen", screen, true}},
                                           {17, {"hard light", hard_light}},
                                           {18, {"difference", difference_of}},
                                           {19, {"alpha over"}},
                                           {20, {"overlay", overlay}},
                                           {straight_onto, {"straight onto", onto}},
                                           {22, {"add composite", add}},
                                           {23, {"alpha intersection"}}};
    return all;
}

int method_of(const Layer& layer) { return layer.whole("blend_method", 0, composite); }

/// Such layers erase from what is below, and show nothing of their own.
bool erases(int method) { return method == 14 || method == 15 || method == 19 || method == 23; }

/// Such layers are drawn where nothing is below, too.
bool stands_alone(int method) { return method == straight || method == 22; }

std::string feature(int method)
{
    const auto found = methods().find(method);
    return "blend method " +
           (found == methods().end() ? std::to_string(method) : '"' + std::string{found->second.name} + '"');
}

bool is_opaque(const Layer& layer)
{
    return layer.number("amount", 0, 1) >= 1 && layer.bends({"amount"}).empty();
}

Blending blending_everywhere(const Layer& layer, int method)
{
    const auto found = methods().find(method);
    if (found != methods().end() && found->second.tinting) {
        if (!found->second.is_exact)
            layer.lose(feature(method), "changes the colour of each layer below by itself");
        return Blending::tinting;
    }
    layer.lose(feature(method), "the layer is left out");
    return Blending::left_out;
}

}

Blending blending_of(const Layer& layer, Extent extent, bool lies_lowest)
{
    const int method = method_of(layer);
    if (method == composite)
        return Blending::normal;
    if (method == behind)
        return Blending::behind;
    if (lies_lowest && methods().contains(method))
        return stands_alone(method) ? Blending::normal : Blending::left_out;
    if (method == straight && is_opaque(layer))
        return Blending::replacing;
    if (extent == Extent::everywhere)
        return blending_everywhere(layer, method);
    if (method == straight_onto && is_opaque(layer)) {
        layer.lose(feature(method), "painted instead of what lies below, even beyond it");
        return Blending::replacing;
    }
    // Painted over, an inverted shape would cover all of the canvas, not only what is below it.
    const bool left_out = erases(method) || layer.truth("invert", 0, false);
    layer.lose(feature(method), left_out ? "the layer is left out" : "painted over what lies below");
    return left_out ? Blending::left_out : Blending::normal;
}

bool is_composite(const Layer& layer) { return method_of(layer) == composite; }

bool takes_away(const Layer& layer) { return erases(method_of(layer)); }

Tinting tinting_of(const Layer& layer)
{
    const auto found = methods().find(method_of(layer));
    return found == methods().end() ? nullptr : found->second.tinting;
}

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
