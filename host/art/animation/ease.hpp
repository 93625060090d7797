#pragma once

#include <cstdint>
#include <vector>

namespace kfast::art {

enum class EaseKind : std::uint8_t {
    linear,
    hold,  ///< the earlier value stays until the time of the next key
    cubic, ///< CSS's cubic-bezier()
};

/// How a value goes from one key to the next.
struct Ease {
    EaseKind kind = EaseKind::linear;
    /// The inner control points of a cubic; those of x are 0 to 1, those of y any.
    double x1 = 0;
    double y1 = 0;
    double x2 = 1;
    double y2 = 1;
    friend bool operator==(const Ease&, const Ease&) = default;
};

/// The progress at `time`, which is a fraction of the duration from 0 to 1.
double share_of_way(const Ease& ease, double time);

/// The parameter of a cubic ease's curve at `time`, a fraction from 0 to 1.
double parameter_at(const Ease& ease, double time);

/// A part of an ease, as an ease of its own.
struct EasePart {
    double from = 0; ///< fractions of the whole ease's time
    double to = 1;
    double way_from = 0; ///< fractions of the whole progress
    double way_to = 1;
    Ease ease;
};

/// What the ease does between two fractions of its time, 0 <= from < to <= 1: mostly one part. Several, one
/// after the other, where no single ease represents it: where the progress reverses near its ends, or its
/// speed changes too much. The y of cubics that had to be divided are -1/3 to 4/3; others are at most
/// `highest_y` from 1/2.
std::vector<EasePart> ease_parts(const Ease& ease, double from, double to);

/// How far from 1/2 the control points of a part may be in y: the scene language allows -2 to 3.
inline constexpr double highest_y = 2.5;

/// How far the progress may be, between two fractions of the time, from the straight line between its values
/// at these times. Never too little; for half of the time, a quarter in the limit.
double bend_of(const Ease& ease, double from, double to);

/// The least and the greatest progress that it may come to: never too narrow.
struct ProgressRange {
    double low = 0;
    double high = 1;
};
ProgressRange progress_range(const Ease& ease);

/// The same ease in the other direction of time; for a hold, a hold (which is not the same: the value held
/// then is the later one).
Ease reversed(const Ease& ease);

}
