#include "core/time/spring_law.hpp"

#include "core/features.hpp"
#include "tests/rounds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <doctest/doctest.h>
#include <numbers>
#include <random>

namespace kfast::test {
namespace {

using Kind = VelocityLaw::Kind;

constexpr std::array ends{SpringEnd::next, SpringEnd::earlier, SpringEnd::both};

/// A ball that falls from 0 to the ground at 1, by the physics of the fall and of each bounce.
double exact_bounce(unsigned n, double time)
{
    double at = time * (3 - std::exp2(1 - double(n))); // in lengths of the fall
    if (at <= 1)
        return at * at;
    double length = 1;
    for (at -= 1; at > length; length /= 2)
        at -= length;
    return 1 - at * (length - at);
}

double exact_swing(const Oscillation& numbers, double time)
{
    const double angle = 2 * std::numbers::pi * numbers.turns / 4096 * time;
    const double left = std::exp2(-numbers.decay / 1024.0 * time);
    return numbers.size / 16384.0 * (1 - left * (std::cos(angle) + numbers.lean / 2048.0 * std::sin(angle)));
}

double exact_to_rest(const VelocityLaw& law, double time)
{
    return law.kind == Kind::bounce ? exact_bounce(bounces_of(law), time)
                                    : exact_swing(oscillation_of(law), time);
}

double exact_spring(const VelocityLaw& law, double time)
{
    if (end_of(law) == SpringEnd::next)
        return exact_to_rest(law, time);
    if (end_of(law) == SpringEnd::earlier)
        return 1 - exact_to_rest(law, 1 - time);
    return time < 0.5 ? (1 - exact_to_rest(law, 1 - 2 * time)) / 2
                      : (1 + exact_to_rest(law, 2 * time - 1)) / 2;
}

Progress way(const VelocityLaw& law, std::uint32_t time) { return progress(law, {time}, &kfast_springs); }

double error_at(const VelocityLaw& law, std::uint32_t time)
{
    return std::abs(way(law, time).raw - exact_spring(law, time / 65536.0) * 65536);
}

double worst_error(const VelocityLaw& law)
{
    double worst = 0;
    for (std::uint32_t time = 1; time < Fraction::one; ++time)
        worst = std::max(worst, error_at(law, time));
    return worst;
}

/// Of a spring of mass 1 whose interval lasts a second, whole up to rounding.
Oscillation oscillation(double stiffness, double damping)
{
    const double decay = damping / 2;
    const double speed = std::sqrt(stiffness - decay * decay);
    const double lean = decay / speed;
    const double size = 1 / (1 - std::exp(-decay) * (std::cos(speed) + lean * std::sin(speed)));
    return {static_cast<std::uint16_t>(std::lround(decay / std::numbers::ln2 * 1024)),
            static_cast<std::uint16_t>(std::lround(speed / (2 * std::numbers::pi) * 4096)),
            static_cast<std::int16_t>(std::lround(lean * 2048)),
            static_cast<std::int16_t>(std::lround(size * 16384))};
}

/// Soft, of the usual ways, all but too stiff to swing, the fastest, one that hardly dies down.
const std::array oscillations{oscillation(10, 4),    oscillation(100, 10),   oscillation(180, 12),
                              oscillation(210, 20),  oscillation(170, 26),   oscillation(10000, 80),
                              oscillation(10000, 4), oscillation(1600, 79.8)};

}

TEST_CASE("a bounce is within 0.51 units in the last place of the exact value, over the whole range")
{
    for (std::uint32_t n = 1; n <= spring_count::max_bounces; ++n) {
        CAPTURE(n);
        CHECK(worst_error(bounce_law(n)) <= 0.51);
        CHECK(worst_error(bounce_law(n, SpringEnd::earlier)) <= 0.51);
        CHECK(worst_error(bounce_law(n, SpringEnd::both)) <= 0.76);
    }
}

TEST_CASE("a spring is within 1.5 units in the last place of the exact value, over the whole range")
{
    for (const Oscillation& numbers : oscillations) {
        CAPTURE(&numbers - oscillations.data());
        CHECK(worst_error(spring_law(numbers)) <= 1.5);
        CHECK(worst_error(spring_law(numbers, SpringEnd::earlier)) <= 1.5);
        CHECK(worst_error(spring_law(numbers, SpringEnd::both)) <= 1.25);
    }
}

TEST_CASE("springs and bounces begin at 0 and end at 1, and come there without a jump")
{
    const auto check_ends = [](const VelocityLaw& law, int furthest) {
        CHECK(way(law, 0).raw == 0);
        CHECK(way(law, Fraction::one).raw == Progress::one);
        CHECK(std::abs(way(law, 1).raw) <= furthest);
        CHECK(std::abs(Progress::one - way(law, Fraction::one - 1).raw) <= furthest);
    };
    for (const SpringEnd end : ends) {
        for (std::uint32_t n = 1; n <= spring_count::max_bounces; ++n)
            check_ends(bounce_law(n, end), 3);
        for (const Oscillation& numbers : oscillations)
            check_ends(spring_law(numbers, end), 10);
    }
}

TEST_CASE("a bounce touches the next key as often as it says, and never goes beyond it")
{
    for (std::uint32_t n = 1; n <= spring_count::max_bounces; ++n) {
        std::uint32_t touches = 0;
        for (std::uint32_t time = 1; time <= Fraction::one; ++time) {
            REQUIRE(way(bounce_law(n), time).raw <= Progress::one);
            REQUIRE(way(bounce_law(n), time).raw >= 0);
            const bool rises =
                time < Fraction::one && way(bounce_law(n), time) < way(bounce_law(n), time + 1);
            touches += way(bounce_law(n), time - 1) < way(bounce_law(n), time) && !rises;
        }
        CHECK(touches >= std::min<std::uint32_t>(n, 5) + 1); // lower ones are flat for a while
    }
}

TEST_CASE("any spring keeps its precision where it is in range, and its range")
{
    std::mt19937 random{93};
    const auto any = [&random] { return static_cast<std::uint16_t>(random()); };
    for (int round = 0; round < rounds(20'000); ++round) {
        const Oscillation numbers{any(), any(), static_cast<std::int16_t>(any()),
                                  static_cast<std::int16_t>(any() % 24577)};
        const VelocityLaw law = spring_law(numbers, ends[random() % 3]);
        REQUIRE(is_valid(law));
        const auto time = static_cast<std::uint32_t>(1 + random() % 65535);
        REQUIRE(way(law, time) >= progress_range(law).min);
        REQUIRE(way(law, time) <= progress_range(law).max);
        const double exact = exact_spring(law, time / 65536.0);
        if (end_of(law) == SpringEnd::next && exact > -1.5 && exact < 2.5)
            REQUIRE(error_at(law, time) <= 1.5);
    }
}

TEST_CASE("halfway marks tell springs and bounces apart")
{
    CHECK(way(bounce_law(3), 32768).raw == 50176); // 1 - 15/64, as 7.5625 (t - 1.5 / 2.75)^2 + 0.75 says
    CHECK(way(bounce_law(3, SpringEnd::earlier), 32768).raw == 65536 - 50176);
    CHECK(way(bounce_law(3, SpringEnd::both), 32768).raw == 32768);
    CHECK(way(bounce_law(1), 32768).raw == 65536);
}

TEST_CASE("bounces and springs are valid when their parameters are in their ranges")
{
    for (const SpringEnd end : ends) {
        CHECK(is_valid(bounce_law(1, end)));
        CHECK(is_valid(bounce_law(8, end)));
        CHECK_FALSE(is_valid(bounce_law(0, end)));
        CHECK_FALSE(is_valid(bounce_law(9, end)));
        CHECK(is_valid(spring_law({}, end)));
        CHECK(is_valid(spring_law({65535, 65535, -32768, -32768}, end)));
    }
    CHECK_FALSE(is_valid(bounce_law(3, static_cast<SpringEnd>(3))));
    CHECK_FALSE(is_valid(spring_law({}, static_cast<SpringEnd>(3))));
    CHECK_FALSE(is_valid({.kind = Kind::spring, .count = 1}));
}

TEST_CASE("only springs and bounces need the feature")
{
    CHECK(is_spring(bounce_law(3)));
    CHECK(is_spring(spring_law({})));
    CHECK_FALSE(is_spring(VelocityLaw::constant));
    CHECK_FALSE(is_spring(VelocityLaw::bezier(0, 0, 8192, 8192)));
}

}
