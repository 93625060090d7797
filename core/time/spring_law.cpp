#include "core/time/spring_law.hpp"

#include "core/bytes/op_counter.hpp"
#include "core/math/angle.hpp"
#include "core/math/polynomial.hpp"

#include <algorithm>
#include <array>

namespace kfast {

namespace {

/// 2^-u for u in 0 … 1, within 0.03 / 65536. It interpolates at Chebyshev nodes; the lowest coefficient and
/// the sum of all are adjusted, so that both ends are exact.
constexpr std::array<std::int32_t, 6> halving_terms{1073741824, -744260635, 257928559,
                                                    -59494488,  10033292,   -1077640};

/// 2^-exponent in Q30 for an exponent in Q26.
[[gnu::cold]] std::int32_t halved(std::uint32_t exponent)
{
    constexpr int bits = Oscillation::decay_bits + 16;
    const std::uint32_t whole = exponent >> bits;
    const std::uint32_t rest = exponent & ((1U << bits) - 1);
    return whole > 30 ? 0
                      : polynomial(halving_terms, static_cast<std::int32_t>(rest << (30 - bits))) >> whole;
}

/// The wave and what is left of it are in Q26, so that the steepest lean of 16 stays within 32 bits.
[[gnu::cold]] Progress swung(const Oscillation& oscillation, Fraction time)
{
    constexpr int bits = 26;
    count_op(Op::law, 2); // two sines and a power in the place of one sine
    const FineAngle angle{oscillation.turns * time.raw << (32 - Oscillation::turn_bits - 16)};
    const std::int32_t wave = rounded_shift(cosine(angle), 30 - bits) +
                              multiply(sine(angle), oscillation.lean, 30 + Oscillation::lean_bits - bits);
    const std::int32_t left = multiply(wave, halved(oscillation.decay * time.raw), 30);
    const std::int32_t progress =
        multiply((1 << bits) - left, oscillation.size, bits + Oscillation::size_bits - 16);
    return std::clamp(Progress{progress}, widest_progress.min, widest_progress.max);
}

/// Parabolas d^2 of the time d from their middles. With the length of the fall as the unit of time the whole
/// takes 3 - 2 / 2^n; the parabola k, from that of the fall on, ends at 3 - 2 / 2^k, and its middle is at
/// 3 - 3 / 2^k, 1 / 4^k from the next key.
[[gnu::cold]] Progress bounced(std::uint32_t bounces, Fraction time)
{
    const auto n = static_cast<int>(bounces);
    const int bits = 16 + n;
    const std::int32_t fall = 1 << bits;
    const auto passed = static_cast<std::int32_t>(time.raw * ((3U << n) - 2));
    int k = 0;
    while (passed > 3 * fall - (2 * fall >> k))
        ++k;
    const std::int32_t from_middle = passed - 3 * fall + (3 * fall >> k);
    return {Progress::one - (Progress::one >> 2 * k) + multiply(from_middle, from_middle, 2 * bits - 16)};
}

[[gnu::cold]] Progress to_rest(const VelocityLaw& law, Fraction time)
{
    return law.kind == VelocityLaw::Kind::bounce ? bounced(bounces_of(law), time)
                                                 : swung(oscillation_of(law), time);
}

/// From the earlier key on.
Progress from_rest(const VelocityLaw& law, Fraction time)
{
    return {Progress::one - to_rest(law, {Fraction::one - time.raw}).raw};
}

}

Progress spring_progress(const VelocityLaw& law, Fraction time)
{
    const SpringEnd end = end_of(law);
    if (end == SpringEnd::next)
        return to_rest(law, time);
    if (end == SpringEnd::earlier)
        return from_rest(law, time);
    const std::uint32_t twice = 2 * time.raw;
    const std::int32_t sum = twice < Fraction::one
                                 ? from_rest(law, {twice}).raw
                                 : Progress::one + to_rest(law, {twice - Fraction::one}).raw;
    return {rounded_shift(sum, 1)};
}

}
