#pragma once

#include "core/math/fixed.hpp"

#include <algorithm>
#include <cstdint>

namespace kfast {

struct SpringFeature;

/// How the progress from one key to the next follows from the fraction u of the time.
struct VelocityLaw {
    /// The values are those of the scene format.
    enum class Kind : std::uint8_t {
        constant,              ///< u
        accelerate,            ///< 1 - cos(pi u / 2)
        decelerate,            ///< sin(pi u / 2)
        accelerate_decelerate, ///< (1 - cos(pi u)) / 2
        hold,                  ///< 0 before the end, 1 there
        steps,                 ///< floor(u n) / n, the steps(n) of CSS
        bezier,                ///< the cubic-bezier(x1, y1, x2, y2) of CSS
        bounce,                ///< a fall and n bounces (core/time/spring_law.hpp)
        spring,                ///< an oscillation that dies down (spring_law.hpp)
    };

    Kind kind = Kind::constant;
    /// Of Kind::steps n, 1 … 65535; of bounces and springs as spring_count says.
    std::uint16_t count = 0;
    /// The control points of a bezier in Q13, x from 0 to 1 and y from -2 to 3; of a spring the numbers of
    /// its Oscillation.
    std::int16_t x1 = 0;
    std::int16_t y1 = 0;
    std::int16_t x2 = 0;
    std::int16_t y2 = 0;

    static constexpr std::int16_t control_one = 8192;
    static constexpr std::int16_t lowest_y = -2 * control_one;
    static constexpr std::int16_t highest_y = 3 * control_one;

    static const VelocityLaw constant;
    static const VelocityLaw accelerate;
    static const VelocityLaw decelerate;
    static const VelocityLaw accelerate_decelerate;
    static const VelocityLaw hold;
    static constexpr VelocityLaw in_steps(std::uint16_t count)
    {
        return {.kind = Kind::steps, .count = count};
    }
    static constexpr VelocityLaw bezier(std::int16_t x1, std::int16_t y1, std::int16_t x2, std::int16_t y2)
    {
        return {.kind = Kind::bezier, .x1 = x1, .y1 = y1, .x2 = x2, .y2 = y2};
    }

    friend constexpr bool operator==(const VelocityLaw&, const VelocityLaw&) = default;
};

inline constexpr VelocityLaw VelocityLaw::constant{};
inline constexpr VelocityLaw VelocityLaw::accelerate{.kind = Kind::accelerate};
inline constexpr VelocityLaw VelocityLaw::decelerate{.kind = Kind::decelerate};
inline constexpr VelocityLaw VelocityLaw::accelerate_decelerate{.kind = Kind::accelerate_decelerate};
inline constexpr VelocityLaw VelocityLaw::hold{.kind = Kind::hold};

/// Where a bounce or a spring has its bounces or swings: before the next key, after the earlier one, or half
/// of the time at each.
enum class SpringEnd : std::uint8_t { next, earlier, both };

/// Bits of VelocityLaw::count.
namespace spring_count {
inline constexpr std::uint32_t number = 0xFF; ///< of bounces; of a spring 0
inline constexpr int end_shift = 8;           ///< SpringEnd
inline constexpr std::uint32_t max_bounces = 8;
}

/// Whether Feature::springs is needed.
constexpr bool is_spring(const VelocityLaw& law)
{
    return law.kind == VelocityLaw::Kind::bounce || law.kind == VelocityLaw::Kind::spring;
}

/// Whether the kind is known and the parameters that it has are in their ranges.
constexpr bool is_valid(const VelocityLaw& law)
{
    const auto is_x = [](int x) { return x >= 0 && x <= VelocityLaw::control_one; };
    const auto is_y = [](int y) { return y >= VelocityLaw::lowest_y && y <= VelocityLaw::highest_y; };
    const std::uint32_t number = law.count & spring_count::number;
    const bool is_end = law.count >> spring_count::end_shift <= static_cast<int>(SpringEnd::both);
    switch (law.kind) {
    case VelocityLaw::Kind::constant:
    case VelocityLaw::Kind::accelerate:
    case VelocityLaw::Kind::decelerate:
    case VelocityLaw::Kind::accelerate_decelerate:
    case VelocityLaw::Kind::hold:
        return true;
    case VelocityLaw::Kind::steps:
        return law.count >= 1;
    case VelocityLaw::Kind::bezier:
        return is_x(law.x1) && is_y(law.y1) && is_x(law.x2) && is_y(law.y2);
    case VelocityLaw::Kind::bounce:
        return is_end && number >= 1 && number <= spring_count::max_bounces;
    case VelocityLaw::Kind::spring:
        return is_end && number == 0; // any oscillation is kept in range
    }
    return false;
}

/// The progress at the fraction `time` of the time; `law` is valid. 0 at 0 and 1 at 1 exactly.
///
/// - constant, hold: exact.
/// - accelerate, decelerate, accelerate-decelerate: rounded once, within 0.51 units of 1/65536 of the exact
///   value; never fall.
/// - steps: k/n, rounded to nearest, from the fraction on that is nearest to k/n. So a step is not missed at
///   a time whose fraction has been rounded down.
/// - bezier: within 0.6 units of the exact value at a time that is within 0.1 units of `time`, and so within
///   0.6 + 0.1 times the slope. Never falls where y1 and y2 are in 0 … 1. Leaves 0 … 1 as progress_range()
///   says.
/// - bounce, spring: spring_progress(), which only programs with Feature::springs have. They give `springs`.
Progress progress(const VelocityLaw& law, Fraction time, const SpringFeature* springs = nullptr);

struct ProgressRange {
    Progress min = {0};             ///< or below
    Progress max = {Progress::one}; ///< or above
};

inline constexpr ProgressRange widest_progress{{-Progress::one * 3 / 2}, {Progress::one * 5 / 2}};

/// Bounds of the progress, -1.5 … 0 and 1 … 2.5. Those of springs are the widest. A control point that is d
/// outside of 0 … 1 takes the curve no further than 3/4 d: the weights of both control points together are 3
/// s (1 - s).
constexpr ProgressRange progress_range(const VelocityLaw& law)
{
    if (law.kind == VelocityLaw::Kind::spring)
        return widest_progress;
    if (law.kind != VelocityLaw::Kind::bezier)
        return {};
    constexpr std::int32_t three_quarters = Progress::one / VelocityLaw::control_one * 3 / 4;
    const std::int32_t below = std::max<std::int32_t>({0, -law.y1, -law.y2});
    const std::int32_t above =
        std::max<std::int32_t>({0, law.y1 - VelocityLaw::control_one, law.y2 - VelocityLaw::control_one});
    return {{-below * three_quarters}, {Progress::one + above * three_quarters}};
}

/// The laws from one key to the next: that of x, which also applies to quantities without an axis, and that
/// of y.
struct LawPair {
    VelocityLaw x = {};
    VelocityLaw y = {};
    friend constexpr bool operator==(const LawPair&, const LawPair&) = default;
};

}
