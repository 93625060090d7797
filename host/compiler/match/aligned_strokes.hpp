#pragma once

#include "host/compiler/match/measured_stroke.hpp"

#include <cstddef>

namespace kfast {

/// How far the start of a closed stroke is shifted along it.
struct Shift {
    std::size_t steps = 0;
    double agreement = 0;
};

/// The shift with the greatest agreement_at(steps) of one round of `count` steps. Among those that differ by
/// no more than `noise`, as by rounding, the one nearest to no shift.
template <class AgreementAt>
Shift best_shift(std::size_t count, double noise, AgreementAt agreement_at)
{
    Shift best{0, agreement_at(0)};
    for (std::size_t away = 1; away <= count / 2; ++away)
        for (const std::size_t steps : {away, count - away})
            if (const double found = agreement_at(steps); found > best.agreement + noise)
                best = {steps, found};
    return best;
}

/// Two strokes whose starts correspond.
struct AlignedStrokes {
    MeasuredStroke a;
    MeasuredStroke b;
    /// What to add to the positions on `b` to have them where they fit `a` best. Not 0 where two vertices
    /// near that position became the start.
    double offset = 0;
};

enum class Reversal { forbidden, allowed };

/// Moves the start of a closed stroke to where the strokes, each with its centre of gravity in the origin,
/// have the smallest sum of squared distances between points at equal fractions of their lengths; that of
/// `b`, if both are closed. The start is a vertex where a vertex of the other is near, otherwise a new point.
/// If it is allowed and fits better, the stroke whose start may move changes its direction. Open strokes stay
/// as they are. Both have a segment.
AlignedStrokes aligned(const MeasuredStroke& a, const MeasuredStroke& b, Reversal reversal);

/// As aligned(), for a part of a broken stroke, which begins where it was broken.
AlignedStrokes aligned_to_part(const MeasuredStroke& part, const MeasuredStroke& partner);

}
