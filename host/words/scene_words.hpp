#pragma once

#include "core/features.hpp"
#include "core/pixel/paint_style.hpp"
#include "core/scene/property.hpp"
#include "core/scene/scene_view.hpp"
#include "core/time/time.hpp"
#include "core/time/velocity_law.hpp"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace kfast {

/// Its name in docs/library.md, kfast.h and reports: "strokes".
std::string_view feature_name(Feature feature);

/// The names of all features of a set, in the order of Feature.
std::vector<std::string> feature_names(FeatureSet set);

/// "strokes, texts"; "no features".
std::string features_text(FeatureSet set);

/// The features of a set, in the order of Feature.
std::vector<Feature> features_in(FeatureSet set);

/// Its name in the scene language, where all lengths of dashes are one list.
constexpr std::string_view property_name(Property property)
{
    constexpr std::array<std::string_view, property_count> names{
        "x",       "y",         "z",       "rotate-x",    "rotate-y",  "rotate",      "scale-x", "scale-y",
        "pivot-x", "pivot-y",   "along",   "opacity",     "order",     "visible",     "fill",    "stroke",
        "width",   "trim-from", "trim-to", "trim-offset", "trim",      "dash-offset", "dash",    "dash",
        "dash",    "dash",      "dash",    "dash",        "max-dashes"};
    return names[static_cast<std::size_t>(property)];
}

/// Converts what a track stores of a property (core/scene/property.hpp) to the unit that the scene language
/// has for it: pixels, degrees, or a fraction. Not for colours, which are no numbers; `order` and `visible`
/// stay as they are.
double written_amount(Property property, double stored);

/// Returns "#rrggbb", or "#rrggbbaa" of a colour that is not opaque.
std::string colour_text(Colour colour);

/// The number of frames, with fractions.
constexpr double in_frames(Time time) { return static_cast<double>(time.ticks) / Time::ticks_per_frame; }

/// The input that `driver` is.
InputView input_of(const SceneView& scene, Driver driver);

/// A time of keys as an author writes it: in frames, or in the values of the input that they go by.
double written_moment(const SceneView& scene, Driver driver, Time moment);

/// Its name in the scene language.
constexpr std::string_view loop_name(Loop loop)
{
    switch (loop) {
    case Loop::once:
        return "once";
    case Loop::repeat:
        return "repeat";
    case Loop::ping_pong:
        return "ping-pong";
    }
    return {};
}

/// As the scene language writes it: "accelerate", "steps(4)", "bezier(0.42,0,0.58,1)".
std::string law_text(const VelocityLaw& law);

}
