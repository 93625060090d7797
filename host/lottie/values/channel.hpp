#pragma once

#include "host/art/animation/animated.hpp"
#include "host/art/budget.hpp"
#include "host/art/document/document.hpp"

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <nlohmann/json_fwd.hpp>

namespace kfast::lottie {

using Json = nlohmann::json;

/// Converts the times of a layer, or of a precomposition, to frames of the scene: start and stretch.
struct LayerTime {
    double start = 0;
    double stretch = 1;  ///< not 0
    art::Span seen = {}; ///< what is seen of it, in frames of the scene: so far loops go on
    double scene_frame(double frame) const { return start + stretch * frame; }
};

/// A property (an object with "k") as a number over time: of its component `index`, if it has several. If
/// eases differ between components, each uses its own. A negative stretch reverses the keys. `factor`
/// multiplies the values (percent: 0.01). A property that is missing is `default_value`; one of another kind
/// throws Failure.
art::Channel read_channel(const Json& owner, const char* name, std::size_t index, double default_value,
                          double factor, const LayerTime& time, art::Budget& budget);

art::Animated<art::Rgb> read_colour(const Json& owner, const char* name, const LayerTime& time,
                                    art::Budget& budget);

/// A property "ks" of a path: "v", "i", "o", "c".
art::Animated<art::Drawing> read_path(const Json& owner, const char* name, const LayerTime& time,
                                      art::Budget& budget);

/// How a number depends on the others that it is computed from.
enum class Dependence {
    linear, ///< on each of them
    curved,
};

/// A number that is computed from others, exactly where only one of them changes and it depends linearly on
/// that one; otherwise baked, within `tolerance`.
art::Channel combined(const std::function<double(double)>& value_at,
                      std::initializer_list<const art::Channel*> channels, Dependence dependence,
                      double tolerance, art::Budget& budget);

}
