#include "core/time/velocity_law.hpp"

#include "tests/core/time/exact_law.hpp"
#include "tests/rounds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <doctest/doctest.h>
#include <numbers>
#include <random>
#include <type_traits>

namespace kfast::test {
namespace {

using Kind = VelocityLaw::Kind;

static_assert(std::is_aggregate_v<VelocityLaw> && std::is_trivially_copyable_v<VelocityLaw>);
static_assert(VelocityLaw{} == VelocityLaw::constant);

constexpr std::array smooth_laws{VelocityLaw::constant, VelocityLaw::accelerate, VelocityLaw::decelerate,
                                 VelocityLaw::accelerate_decelerate};

VelocityLaw bezier(double x1, double y1, double x2, double y2)
{
    const auto q13 = [](double number) { return static_cast<std::int16_t>(std::lround(number * 8192)); };
    return VelocityLaw::bezier(q13(x1), q13(y1), q13(x2), q13(y2));
}

/// The last three have an upright tangent at an end, in the middle, or at both ends.
const std::array rising_beziers{bezier(0.25, 0.1, 0.25, 1), bezier(0.42, 0, 1, 1),    bezier(0, 0, 0.58, 1),
                                bezier(0.42, 0, 0.58, 1),   bezier(0, 0, 1, 1),       bezier(0, 1, 1, 0),
                                bezier(1, 1, 0, 0),         bezier(0.6, 0, 0.9, 0.9), bezier(0, 0, 0, 0),
                                bezier(0, 1, 0, 1),         bezier(1, 0, 0, 1),       bezier(0, 0.5, 1, 0.5)};

const std::array swinging_beziers{bezier(0.5, -2, 0.5, 3),     bezier(0.68, -0.55, 0.27, 1.55),
                                  bezier(0.34, 1.56, 0.64, 1), bezier(0.36, 0, 0.66, -0.56),
                                  bezier(0.3, 3, 0.6, 3),      bezier(0.3, -2, 0.6, -2),
                                  bezier(0, 3, 1, -2),         bezier(0, -2, 0, 3),
                                  bezier(1, 3, 0, -2)};

constexpr std::array<std::uint16_t, 8> step_counts{1, 2, 3, 7, 60, 1000, 4099, 65535};

double cubic(double s, double c1, double c2)
{
    return 3 * (1 - s) * (1 - s) * s * c1 + 3 * (1 - s) * s * s * c2 + s * s * s;
}

double in_q13(std::int16_t control) { return control / 8192.0; }

/// The parameter where x is `time`, in units of 1/65536.
double parameter_at(const VelocityLaw& law, double time)
{
    if (time <= 0 || time >= 65536)
        return time <= 0 ? 0 : 1;
    double low = 0;
    double high = 1;
    for (int halving = 0; halving < 44; ++halving) {
        const double middle = (low + high) / 2;
        (cubic(middle, in_q13(law.x1), in_q13(law.x2)) * 65536 < time ? low : high) = middle;
    }
    return high;
}

double value_at(const VelocityLaw& law, double parameter)
{
    return cubic(parameter, in_q13(law.y1), in_q13(law.y2)) * 65536;
}

/// How far the way at `time` is from all that the exact curve is within `slack` units of `time`.
double bezier_error(const VelocityLaw& law, std::uint32_t time, double slack)
{
    const double begin = parameter_at(law, time - slack);
    const double end = parameter_at(law, time + slack);
    double min = 1e9;
    double max = -1e9;
    for (int i = 0; i <= 4; ++i) {
        const double value = value_at(law, begin + (end - begin) * i / 4);
        min = std::min(min, value);
        max = std::max(max, value);
    }
    const double value = progress(law, {time}).raw;
    return std::max(min - value, value - max);
}

double worst_bezier_error(const VelocityLaw& law, double slack)
{
    double worst = 0;
    for (std::uint32_t time = 0; time <= Fraction::one; ++time)
        worst = std::max(worst, bezier_error(law, time, slack));
    return worst;
}

int falls(const VelocityLaw& law)
{
    int count = 0;
    for (std::uint32_t time = 1; time <= Fraction::one; ++time)
        count += progress(law, {time}) < progress(law, {time - 1});
    return count;
}

void check_ends(const VelocityLaw& law)
{
    CHECK(progress(law, {0}).raw == 0);
    CHECK(progress(law, {Fraction::one}).raw == Progress::one);
}

VelocityLaw random_bezier(std::mt19937& random, int min_y, int max_y)
{
    const auto between = [&random](int low, int high) {
        return static_cast<std::int16_t>(low + static_cast<int>(random() % unsigned(high - low + 1)));
    };
    VelocityLaw law{.kind = Kind::bezier};
    law.x1 = between(0, 8192);
    law.y1 = between(min_y, max_y);
    law.x2 = between(0, 8192);
    law.y2 = between(min_y, max_y);
    return law;
}

}

TEST_CASE("every smooth law is within 0.51 units in the last place of the exact value, over the whole range")
{
    for (const VelocityLaw& law : smooth_laws) {
        double worst = 0;
        for (std::uint32_t time = 0; time <= Fraction::one; ++time) {
            const double error = progress(law, {time}).raw - exact_progress(law, time / 65536.0) * 65536;
            worst = std::max(worst, std::abs(error));
        }
        CAPTURE(static_cast<int>(law.kind));
        CHECK(worst <= 0.51);
    }
}

TEST_CASE("a bezier is within 0.6 units of the exact curve, up to 0.1 units of time, over the whole range")
{
    for (const VelocityLaw& law : rising_beziers) {
        CAPTURE(&law - rising_beziers.data());
        CHECK(worst_bezier_error(law, 0.1) <= 0.6);
    }
    for (const VelocityLaw& law : swinging_beziers) {
        CAPTURE(&law - swinging_beziers.data());
        CHECK(worst_bezier_error(law, 0.1) <= 0.6);
    }
}

TEST_CASE("a bezier that is nowhere steep is within one unit at the very time")
{
    for (const VelocityLaw& law :
         {bezier(0.25, 0.1, 0.25, 1), bezier(0.42, 0, 0.58, 1), bezier(0.6, 0, 0.9, 0.9),
          bezier(0.5, -2, 0.5, 3), bezier(0.68, -0.55, 0.27, 1.55)})
        CHECK(worst_bezier_error(law, 0) <= 1);
    CHECK(worst_bezier_error(bezier(0, 0, 1, 1), 0) < 1e-3);
}

TEST_CASE("any bezier keeps its precision and its range")
{
    std::mt19937 random{91};
    for (int round = 0; round < 4'000; ++round) {
        const VelocityLaw law = random_bezier(random, VelocityLaw::lowest_y, VelocityLaw::highest_y);
        REQUIRE(is_valid(law));
        const ProgressRange range = progress_range(law);
        for (int moment = 0; moment < 20; ++moment) {
            const auto time = static_cast<std::uint32_t>(random() % 65537);
            REQUIRE(bezier_error(law, time, 0.1) <= 0.6);
            REQUIRE(progress(law, {time}) >= range.min);
            REQUIRE(progress(law, {time}) <= range.max);
        }
    }
}

TEST_CASE("no law runs backwards that has no control point outside of 0 … 1")
{
    for (const VelocityLaw& law : smooth_laws)
        CHECK(falls(law) == 0);
    for (const VelocityLaw& law : rising_beziers)
        CHECK(falls(law) == 0);
    std::mt19937 random{92};
    for (int round = 0; round < rounds(60); ++round)
        CHECK(falls(random_bezier(random, 0, VelocityLaw::control_one)) == 0);
    for (const std::uint16_t n : step_counts)
        CHECK(falls(VelocityLaw::in_steps(n)) == 0);
    CHECK(falls(VelocityLaw::hold) == 0);
}

TEST_CASE("every law begins at 0 and ends at 1")
{
    for (const VelocityLaw& law : smooth_laws)
        check_ends(law);
    for (const VelocityLaw& law : rising_beziers)
        check_ends(law);
    for (const VelocityLaw& law : swinging_beziers)
        check_ends(law);
    for (const std::uint16_t n : step_counts)
        check_ends(VelocityLaw::in_steps(n));
    check_ends(VelocityLaw::hold);
}

TEST_CASE("halfway marks tell the laws apart")
{
    CHECK(progress(VelocityLaw::constant, {32768}).raw == 32768);
    CHECK(progress(VelocityLaw::accelerate, {32768}).raw == 19195);
    CHECK(progress(VelocityLaw::decelerate, {32768}).raw == 46341);
    CHECK(progress(VelocityLaw::accelerate_decelerate, {32768}).raw == 32768);
    CHECK(progress(VelocityLaw::accelerate_decelerate, {16384}).raw == 9598);
    CHECK(progress(bezier(0.42, 0, 0.58, 1), {32768}).raw == 32768);
    CHECK(progress(bezier(0.25, 0.1, 0.25, 1), {32768}).raw == 52586);
    CHECK(progress(VelocityLaw::in_steps(3), {32768}).raw == 21845);
    CHECK(progress(VelocityLaw::hold, {32768}).raw == 0);
}

TEST_CASE("hold keeps the earlier key until the very end")
{
    CHECK(progress(VelocityLaw::hold, {1}).raw == 0);
    CHECK(progress(VelocityLaw::hold, {Fraction::one - 1}).raw == 0);
}

TEST_CASE("steps jump at the shares nearest to k/n, to those very shares")
{
    for (const std::uint16_t n : step_counts)
        for (std::uint32_t k = 1; k <= n; ++k) {
            const Fraction jump = Fraction::ratio(k, n);
            REQUIRE(progress(VelocityLaw::in_steps(n), jump).raw == static_cast<std::int32_t>(jump.raw));
            REQUIRE(progress(VelocityLaw::in_steps(n), {jump.raw - 1}).raw ==
                    static_cast<std::int32_t>(Fraction::ratio(k - 1, n).raw));
        }
}

TEST_CASE("a law is valid when its parameters are in their ranges")
{
    for (const VelocityLaw& law : smooth_laws)
        CHECK(is_valid(law));
    CHECK(is_valid(VelocityLaw::hold));
    CHECK(is_valid(VelocityLaw::in_steps(1)));
    CHECK(is_valid(VelocityLaw::in_steps(65535)));
    CHECK_FALSE(is_valid(VelocityLaw::in_steps(0)));
    CHECK_FALSE(is_valid({.kind = static_cast<Kind>(9)}));
    CHECK_FALSE(is_valid({.kind = static_cast<Kind>(255)}));
    CHECK(is_valid(VelocityLaw::bezier(0, -16384, 8192, 24576)));
    CHECK(is_valid(VelocityLaw::bezier(8192, 24576, 0, -16384)));
    CHECK_FALSE(is_valid(VelocityLaw::bezier(-1, 0, 0, 0)));
    CHECK_FALSE(is_valid(VelocityLaw::bezier(8193, 0, 0, 0)));
    CHECK_FALSE(is_valid(VelocityLaw::bezier(0, 0, -1, 0)));
    CHECK_FALSE(is_valid(VelocityLaw::bezier(0, 0, 8193, 0)));
    CHECK_FALSE(is_valid(VelocityLaw::bezier(0, -16385, 0, 0)));
    CHECK_FALSE(is_valid(VelocityLaw::bezier(0, 24577, 0, 0)));
    CHECK_FALSE(is_valid(VelocityLaw::bezier(0, 0, 0, -16385)));
    CHECK_FALSE(is_valid(VelocityLaw::bezier(0, 0, 0, 24577)));
}

TEST_CASE("the way leaves 0 … 1 no further than three quarters of what the control points do")
{
    const auto range_is = [](const VelocityLaw& law, double min, double max) {
        const ProgressRange range = progress_range(law);
        return range.min.raw == min * 65536 && range.max.raw == max * 65536;
    };
    CHECK(range_is(VelocityLaw::constant, 0, 1));
    CHECK(range_is(VelocityLaw::in_steps(4), 0, 1));
    CHECK(range_is(bezier(0.1, 0, 0.9, 1), 0, 1));
    CHECK(range_is(bezier(0, -2, 1, 3), -1.5, 2.5));
    CHECK(range_is(bezier(0, 3, 1, -2), -1.5, 2.5));
    CHECK(range_is(bezier(0, 2, 1, 0.5), 0, 1.75));
}

}
