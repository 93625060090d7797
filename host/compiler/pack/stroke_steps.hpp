#pragma once

#include "host/scene/model.hpp"

#include <compare>
#include <cstdint>
#include <vector>

namespace kfast {

/// The difference of two points, in 1/16 px.
struct Delta {
    std::int32_t x = 0;
    std::int32_t y = 0;

    friend auto operator<=>(const Delta&, const Delta&) = default;
    friend Delta operator-(Delta a) { return {-a.x, -a.y}; }
    friend Delta operator+(Delta a, Delta b) { return {a.x + b.x, a.y + b.y}; }
    friend Delta operator-(Delta a, Delta b) { return {a.x - b.x, a.y - b.y}; }
};

/// A segment, wherever it begins.
struct Step {
    bool cubic = false;
    Delta end = {};  ///< from the beginning
    Delta c1 = {};   ///< from the beginning
    Delta back = {}; ///< the second control point from the end

    friend auto operator<=>(const Step&, const Step&) = default;
};

/// A stroke, wherever it begins.
using Steps = std::vector<Step>;

Steps steps_of(const scene::Stroke& stroke);
/// With x, y or both the other way.
Steps mirrored(const Steps& steps, bool x, bool y);

}
