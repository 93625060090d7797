#pragma once

#include "core/math/fixed.hpp"
#include "core/time/velocity_law.hpp"

#include <cstdint>

/// The laws of Feature::springs. Both come to rest at the next key; SpringEnd turns them round.
namespace kfast {

/// What the law Kind::spring goes by. At the fraction u of the time its progress is
///
///     size (1 - 2^(-decay u) (cos a + lean sin a)), where a is turns u full turns.
///
/// It begins at 0. Whoever makes one chooses the size so that it ends at 1.
struct Oscillation {
    std::uint16_t decay = 0; ///< in 1/1024: how often the swing halves
    std::uint16_t turns = 0; ///< in 1/4096
    std::int16_t lean = 0;   ///< in 1/2048
    std::int16_t size = 0;   ///< in 1/16384

    static constexpr int decay_bits = 10;
    static constexpr int turn_bits = 12;
    static constexpr int lean_bits = 11;
    static constexpr int size_bits = 14;

    friend constexpr bool operator==(const Oscillation&, const Oscillation&) = default;
};

constexpr std::uint16_t packed_count(std::uint32_t number, SpringEnd end)
{
    return static_cast<std::uint16_t>(number | static_cast<std::uint32_t>(end) << spring_count::end_shift);
}

/// A fall and `bounces` bounces, 1 … spring_count::max_bounces, each half as long as the one before.
constexpr VelocityLaw bounce_law(std::uint32_t bounces, SpringEnd end = SpringEnd::next)
{
    return {.kind = VelocityLaw::Kind::bounce, .count = packed_count(bounces, end)};
}

constexpr VelocityLaw spring_law(const Oscillation& oscillation, SpringEnd end = SpringEnd::next)
{
    return {.kind = VelocityLaw::Kind::spring,
            .count = packed_count(0, end),
            .x1 = static_cast<std::int16_t>(oscillation.decay),
            .y1 = static_cast<std::int16_t>(oscillation.turns),
            .x2 = oscillation.lean,
            .y2 = oscillation.size};
}

/// Of a spring or a bounce.
constexpr SpringEnd end_of(const VelocityLaw& law)
{
    return static_cast<SpringEnd>(law.count >> spring_count::end_shift);
}

/// Of a bounce.
constexpr std::uint32_t bounces_of(const VelocityLaw& law) { return law.count & spring_count::number; }

/// Of a spring.
constexpr Oscillation oscillation_of(const VelocityLaw& law)
{
    return {static_cast<std::uint16_t>(law.x1), static_cast<std::uint16_t>(law.y1), law.x2, law.y2};
}

/// The progress of a valid bounce or spring at the fraction `time` of the time, which is neither 0 nor 1.
///
/// - bounce: within 0.51 units of 1/65536 of the exact value, within 0 … 1.
/// - spring: within 1.5 units of the exact value for sizes of at most 1.5, at times at which the progress is
///   within -1.5 … 2.5; beyond, it is the nearest of these.
/// - With SpringEnd::both the errors are half as large, and 0.5 units of rounding more.
[[gnu::cold]] Progress spring_progress(const VelocityLaw& law, Fraction time);

}
