#pragma once

#include <cstddef>

namespace kfast {

/// How far a closed stroke is turned along itself.
struct Shift {
    std::size_t steps = 0;
    double agreement = 0;
};

/// The shift with the greatest agreement_at(steps) of one round of `count` steps. Of those that differ by no
/// more than `noise`, which rounding may make, the one nearest to no shift.
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

}
