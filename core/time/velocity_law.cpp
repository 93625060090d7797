#include "core/time/velocity_law.hpp"

#include "core/bytes/work.hpp"
#include "core/math/angle.hpp"

namespace kfast {
namespace {

constexpr Way way_of(Share share) { return {static_cast<std::int32_t>(share.raw)}; }

Share decelerated(Share time) { return {(static_cast<std::uint32_t>(quarter_sine(time)) + (1 << 13)) >> 14}; }

// (1 - cos 2a) / 2 = sin^2 a: squaring keeps the precision near both ends.
Share accelerated_decelerated(Share time)
{
    const auto sine = static_cast<std::uint64_t>(quarter_sine(time));
    return {static_cast<std::uint32_t>((sine * sine + (std::uint64_t{1} << 43)) >> 44)};
}

/// The last step whose share, rounded, has come. n is below 2^16 and so all fits in 32 bits.
Share stepped(Share time, std::uint32_t n) { return Share::ratio((time.raw * n + (n - 1) / 2) >> 16, n); }

/// A cubic Bezier polynomial in Q24.
struct Cubic {
    std::int32_t from;
    std::int32_t c1;
    std::int32_t c2;
    std::int32_t to;
};

// Rounding down both times keeps the order of the control points: what rises goes on to rise.
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
/// de Casteljau's construction needs only sums and shifts, and after twelve halvings a line stands for what
/// is left. It is less than 0.01 units from the curve in x and 0.03 in y: of the largest second differences,
/// 2 and 7, it is 3/4 over 2^24.
Way way_on(Cubic x, Cubic y, Share time)
{
    const auto target = static_cast<std::int32_t>(time.raw << 8);
    for (int halving = 0; halving < 12; ++halving) {
        const auto half = target < first_half(x).to ? first_half : second_half;
        x = half(x);
        y = half(y);
    }
    const Share share =
        Share::ratio(static_cast<std::uint32_t>(target - x.from),
                     static_cast<std::uint32_t>(x.to - x.from)); // below 2^14: 32-bit division
    return {(lerp(Fixed::from_raw(y.from), Fixed::from_raw(y.to), share).raw() + (1 << 7)) >> 8};
}

}

Way progress(const VelocityLaw& law, Share time)
{
    if (time == Share{} || time.raw == Share::one)
        return way_of(time);
    did(law.kind == VelocityLaw::Kind::bezier ? Work::bezier_law : Work::law);
    switch (law.kind) {
    case VelocityLaw::Kind::constant:
        return way_of(time);
    case VelocityLaw::Kind::accelerate:
        return {Way::one - way_of(decelerated({Share::one - time.raw})).raw};
    case VelocityLaw::Kind::decelerate:
        return way_of(decelerated(time));
    case VelocityLaw::Kind::accelerate_decelerate:
        return way_of(accelerated_decelerated(time));
    case VelocityLaw::Kind::hold:
        return {};
    case VelocityLaw::Kind::steps:
        return way_of(stepped(time, law.steps));
    case VelocityLaw::Kind::bezier:
        return way_on(from_0_to_1(law.x1, law.x2), from_0_to_1(law.y1, law.y2), time);
    }
    return way_of(time);
}

}
