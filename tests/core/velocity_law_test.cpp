#include "core/velocity_law.hpp"

#include <array>
#include <cmath>
#include <doctest/doctest.h>
#include <numbers>

namespace kfast::test {
namespace {

double exact(VelocityLaw law, double time)
{
    using std::numbers::pi;
    switch (law) {
    case VelocityLaw::constant:
        return time;
    case VelocityLaw::accelerate:
        return 1 - std::cos(pi * time / 2);
    case VelocityLaw::decelerate:
        return std::sin(pi * time / 2);
    case VelocityLaw::accelerate_decelerate:
        return (1 - std::cos(pi * time)) / 2;
    }
    return -1;
}

constexpr std::array laws{VelocityLaw::constant, VelocityLaw::accelerate, VelocityLaw::decelerate,
                          VelocityLaw::accelerate_decelerate};
static_assert(laws.size() == velocity_law_count);

TEST_CASE("every law is within 0.51 units in the last place of the exact value, over the whole range")
{
    for (const VelocityLaw law : laws) {
        double worst = 0;
        for (std::uint32_t time = 0; time <= Share::one; ++time) {
            const double error = progress(law, {time}).raw - exact(law, time / 65536.0) * 65536;
            worst = std::max(worst, std::abs(error));
        }
        CAPTURE(static_cast<int>(law));
        CHECK(worst <= 0.51);
    }
}

TEST_CASE("no law ever runs backwards")
{
    for (const VelocityLaw law : laws) {
        int falls = 0;
        for (std::uint32_t time = 1; time <= Share::one; ++time)
            falls += progress(law, {time}) < progress(law, {time - 1});
        CAPTURE(static_cast<int>(law));
        CHECK(falls == 0);
    }
}

TEST_CASE("every law begins at 0 and ends at 1")
{
    for (const VelocityLaw law : laws) {
        CHECK(progress(law, {0}).raw == 0);
        CHECK(progress(law, {Share::one}).raw == Share::one);
    }
}

TEST_CASE("halfway marks tell the laws apart")
{
    CHECK(progress(VelocityLaw::constant, {32768}).raw == 32768);
    CHECK(progress(VelocityLaw::accelerate, {32768}).raw == 19195);
    CHECK(progress(VelocityLaw::decelerate, {32768}).raw == 46341);
    CHECK(progress(VelocityLaw::accelerate_decelerate, {32768}).raw == 32768);
    CHECK(progress(VelocityLaw::accelerate_decelerate, {16384}).raw == 9598);
}

}
}
