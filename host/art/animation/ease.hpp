#pragma once

#include <cstdint>

namespace kfast::art {

enum class EaseKind : std::uint8_t {
    linear,
    hold,  ///< the earlier value stays until the time of the next key
    cubic, ///< the cubic-bezier of CSS
};

/// How a value goes from a key to the next one.
struct Ease {
    EaseKind kind = EaseKind::linear;
    /// The inner control points of a cubic; those of x are 0 to 1, those of y any.
    double x1 = 0;
    double y1 = 0;
    double x2 = 1;
    double y2 = 1;
    friend bool operator==(const Ease&, const Ease&) = default;
};

/// The share of the way at `time`, a share of the time from 0 to 1.
double share_of_way(const Ease& ease, double time);

/// The parameter of a cubic ease's curve at `time`, a share from 0 to 1.
double parameter_at(const Ease& ease, double time);

}
