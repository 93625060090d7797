#include "core/time/velocity_law.hpp"

#include "core/bytes/op_counter.hpp"
#include "core/features.hpp"
#include "core/math/angle.hpp"

namespace kfast {

namespace {

constexpr Progress progress_of(Fraction fraction) { return {static_cast<std::int32_t>(fraction.raw)}; }

Fraction decelerated(Fraction time)
{
    return {(static_cast<std::uint32_t>(quarter_sine(time)) + (1 << 13)) >> 14};
}

// (1 - cos 2a) / 2 = sin^2 a: squaring keeps the precision near both ends.
Fraction accelerated_decelerated(Fraction time)
{
    const auto sine = static_cast<std::uint64_t>(quarter_sine(time));
    return {static_cast<std::uint32_t>((sine * sine + (std::uint64_t{1} << 43)) >> 44)};
}

/// The last step whose fraction, rounded, has been reached. n is below 2^16, so all fits in 32 bits.
Fraction stepped(Fraction time, std::uint32_t n)
{
    return Fraction::ratio((time.raw * n + (n - 1) / 2) >> 16, n);
}

/// A cubic Bezier polynomial in Q24.
struct Cubic {
    std::int32_t from;
    std::int32_t c1;
    std::int32_t c2;
    std::int32_t to;
};

// Rounding down both times keeps the order of the control points: what rises still rises.
constexpr std::int32_t middle(std::int32_t a, std::int32_t b) { return (a + b) >> 1; }

Cubic first_half(const Cubic& whole)
{
    const std::int32_t a = middle(whole.from, whole.c1);
    const std::int32_t b = middle(whole.c1, whole.c2);
    const std::int32_t c = middle(whole.c2, whole.to);
    const std::int32_t ab = middle(a, b);
    return {whole.from, a, ab, middle(ab, middle(b, c))};
}

Cubic second_half(const Cubic& whole)
{
    const std::int32_t a = middle(whole.from, whole.c1);
    const std::int32_t b = middle(whole.c1, whole.c2);
    const std::int32_t c = middle(whole.c2, whole.to);
    const std::int32_t bc = middle(b, c);
    return {middle(middle(a, b), bc), bc, c, whole.to};
}

constexpr Cubic from_0_to_1(std::int32_t c1, std::int32_t c2)
{
    constexpr std::int32_t to_q24 = (1 << 24) / VelocityLaw::control_one;
    return {0, c1 * to_q24, c2 * to_q24, 1 << 24};
}

/// x rises with the parameter, so that the half which holds x = `time` is known from the x in the middle:
/// de Casteljau's construction needs only sums and shifts, and after twelve halvings a line replaces the
/// rest. It is less than 0.01 units from the curve in x and 0.03 in y: of the largest second differences,
/// 2 and 7, it is 3/4 over 2^24.
Progress progress_on(Cubic x, Cubic y, Fraction time)
{
    const auto target = static_cast<std::int32_t>(time.raw << 8);
    for (int halving = 0; halving < 12; ++halving) {
        const auto half = target < first_half(x).to ? first_half : second_half;
        x = half(x);
        y = half(y);
    }
    const Fraction fraction =
        Fraction::ratio(static_cast<std::uint32_t>(target - x.from),
                        static_cast<std::uint32_t>(x.to - x.from)); // below 2^14: 32-bit division
    return {(lerp(Fixed::from_raw(y.from), Fixed::from_raw(y.to), fraction).raw() + (1 << 7)) >> 8};
}

}

Progress progress(const VelocityLaw& law, Fraction time, const SpringFeature* springs)
{
    if (time == Fraction{} || time.raw == Fraction::one)
        return progress_of(time);
    count_op(law.kind == VelocityLaw::Kind::bezier ? Op::bezier_law : Op::law);
    switch (law.kind) {
    case VelocityLaw::Kind::constant:
        return progress_of(time);
    case VelocityLaw::Kind::accelerate:
        return {Progress::one - progress_of(decelerated({Fraction::one - time.raw})).raw};
    case VelocityLaw::Kind::decelerate:
        return progress_of(decelerated(time));
    case VelocityLaw::Kind::accelerate_decelerate:
        return progress_of(accelerated_decelerated(time));
    case VelocityLaw::Kind::hold:
        return {};
    case VelocityLaw::Kind::steps:
        return progress_of(stepped(time, law.count));
    case VelocityLaw::Kind::bezier:
        return progress_on(from_0_to_1(law.x1, law.x2), from_0_to_1(law.y1, law.y2), time);
    case VelocityLaw::Kind::bounce:
    case VelocityLaw::Kind::spring:
        expects(springs != nullptr);
        return springs->progress(law, time);
    }
    return progress_of(time);
}

}
