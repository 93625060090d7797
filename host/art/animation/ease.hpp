#pragma once

#include <cstdint>
#include <vector>

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

/// A stretch of an ease, as an ease of its own.
struct EasePart {
    double from = 0; ///< shares of the whole ease's time
    double to = 1;
    double way_from = 0; ///< shares of the whole way
    double way_to = 1;
    Ease ease;
};

/// What the ease does between two shares of its time, 0 <= from < to <= 1: mostly one part. Several, one
/// after the other, where no single ease can say it: where the way turns back near its ends, or its speed
/// changes too much. The y of cubics that had to be divided are -1/3 to 4/3; others are at most `highest_y`
/// from 1/2.
std::vector<EasePart> ease_parts(const Ease& ease, double from, double to);

/// How far from 1/2 the control points of a part may be in y: what the scene's language has, -2 to 3.
inline constexpr double highest_y = 2.5;

/// How far the way may be, between two shares of the time, from the straight way between where it is at these
/// times, in shares of the whole way. Never too little; a quarter for half of the time, in the end.
double bend_of(const Ease& ease, double from, double to);

/// The least and the greatest share of the way that it may come to: never too little.
struct ProgressRange {
    double low = 0;
    double high = 1;
};
ProgressRange progress_range(const Ease& ease);

/// The ease that goes the same way in the other direction of time; of a hold, a hold (which does not: what is
/// held then is the later value).
Ease reversed(const Ease& ease);

}
