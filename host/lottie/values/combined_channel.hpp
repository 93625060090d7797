#pragma once

#include "host/art/animation/animated.hpp"
#include "host/art/budget.hpp"

#include <functional>
#include <initializer_list>

namespace kfast::lottie {

/// How a number depends on the others that it is computed from.
enum class Dependence {
    linear, ///< on each of them
    curved,
};

/// A number that is computed from others, exactly where only one of them changes and it depends on that one
/// by a straight line; otherwise baked, within `tolerance`.
art::Channel combined(const std::function<double(double)>& value_at,
                      std::initializer_list<const art::Channel*> channels, Dependence dependence,
                      double tolerance, art::Budget& budget);

}
