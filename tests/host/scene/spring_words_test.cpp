#include "host/words/spring_words.hpp"

#include "core/features.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <doctest/doctest.h>
#include <numbers>

namespace kfast::test {
namespace {

Progress way(const VelocityLaw& law, std::uint32_t time) { return progress(law, {time}, &kfast_springs); }

/// x" = stiffness (1 - x) - damping x' over a second, without the correction of its end.
double exact_spring(double stiffness, double damping, double time)
{
    const double decay = damping / 2;
    const double speed = std::sqrt(stiffness - decay * decay);
    return 1 - std::exp(-decay * time) * (std::cos(speed * time) + decay / speed * std::sin(speed * time));
}

double worst_error(double stiffness, double damping)
{
    const VelocityLaw law = mass_on_spring(stiffness, damping);
    double worst = 0;
    for (std::uint32_t time = 1; time < Fraction::one; ++time) {
        const double exact =
            exact_spring(stiffness, damping, time / 65536.0) / exact_spring(stiffness, damping, 1);
        worst = std::max(worst, std::abs(way(law, time).raw - exact * 65536));
    }
    return worst;
}

/// How far it is from the next key just before that.
std::int32_t jump(const VelocityLaw& law)
{
    return std::abs(way(law, Fraction::one - 1).raw - Progress::one);
}

}

TEST_CASE("a spring is that of the physics, within 10 units in the last place")
{
    CHECK(worst_error(100, 10) <= 10);
    CHECK(worst_error(180, 12) <= 10);
    CHECK(worst_error(210, 20) <= 10);
    CHECK(worst_error(170, 26) <= 10);
    CHECK(worst_error(10, 4) <= 10);
    CHECK(worst_error(10000, 4) <= 24); // its whole turns are rounded, too
}

TEST_CASE("every spring ends without a jump, and stays in the range of progress")
{
    for (double stiffness = spring_limits::min_stiffness; stiffness <= spring_limits::max_stiffness;
         stiffness *= 1.3)
        for (double damping = spring_limits::min_damping;
             damping <= std::min(max_damping_of(stiffness), spring_limits::max_damping); damping *= 1.2) {
            CAPTURE(stiffness);
            CAPTURE(damping);
            const VelocityLaw law = mass_on_spring(stiffness, damping);
            CHECK(jump(law) <= 20); // a unit, and what the swing has left of its speed
            for (std::uint32_t time = 0; time < Fraction::one; time += 64) {
                CHECK(way(law, time) >= Progress{-4});
                CHECK(way(law, time) < widest_progress.max);
            }
        }
    for (const double period : {0.1, 0.3, 0.45, 1.0})
        CHECK(jump(elastic_law(period, SpringEnd::next)) <= 3);
}

TEST_CASE("springs and bounces are written as they may be read again")
{
    CHECK(spring_text(bounce_law(3)) == "bounce(3)");
    CHECK(spring_text(bounce_law(1, SpringEnd::both)) == "bounce-in-out(1)");
    CHECK(spring_text(mass_on_spring(100, 10)) == "spring(100,10)");
    CHECK(spring_text(mass_on_spring(170, 26)) == "spring(170,26)");
    CHECK(spring_text(mass_on_spring(10000, 4)) == "spring(10000,4)");
    CHECK(spring_text(elastic_law(0.3, SpringEnd::next)) == "elastic(0.3)");
    CHECK(spring_text(elastic_law(0.45, SpringEnd::both)) == "elastic-in-out(0.45)");
    CHECK(spring_text(elastic_law(1, SpringEnd::earlier)) == "elastic-in(1)");
}

}
