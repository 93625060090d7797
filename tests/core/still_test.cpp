#include "core/still.hpp"

#include <doctest/doctest.h>
#include <random>

namespace kfast::test {
namespace {

constexpr Time first = Time::frame(3);

Still between(Time to, Time moment, const VelocityLaw& law)
{
    return still_between(first, to, moment, {law, law});
}

Progress progress_at(Time to, std::int32_t ticks, const LawPair& laws)
{
    return progress_between(first, to, Time{ticks}, laws);
}

bool are_equal(const Progress& a, const Progress& b) { return a.x == b.x && a.y == b.y; }

}

TEST_CASE("what holds is still all the way, what moves is not")
{
    const Time to = Time::frame(5);
    const Time moment = Time::frame(4);
    CHECK(between(to, moment, VelocityLaw::hold) == Still{first, to});
    CHECK(between(to, moment, VelocityLaw::accelerate) == moving_at(moment));
    CHECK(still_between(first, to, moment, {VelocityLaw::hold, VelocityLaw::constant}) == moving_at(moment));
}

TEST_CASE("a step is still up to the next, from its first frame on")
{
    const Time to = Time::frame(3 + 32);
    for (int step = 0; step < 8; ++step)
        for (int frame = 0; frame < 4; ++frame) {
            const Still still = between(to, Time::frame(3 + 4 * step + frame), VelocityLaw::in_steps(8));
            CHECK(still.contains(Time::frame(3 + 4 * step + 3)));
            CHECK_FALSE(still.contains(Time::frame(3 + 4 * step + 4)));
            CHECK_FALSE(still.contains(Time::frame(3 + 4 * step - 1)));
        }
}

TEST_CASE("nothing moves while steps are still")
{
    std::mt19937 random{20};
    for (int round = 0; round < 300; ++round) {
        const Time to = first + Time{1 + static_cast<std::int32_t>(random() % 6000)};
        const auto steps = [&] {
            return VelocityLaw::in_steps(static_cast<std::uint16_t>(1 + random() % 40));
        };
        const LawPair laws{steps(), round % 3 == 0 ? VelocityLaw::hold : steps()};
        const auto whole = static_cast<std::uint32_t>((to - first).ticks);
        const Time moment = first + Time{static_cast<std::int32_t>(random() % whole)};
        const Still still = still_between(first, to, moment, laws);
        REQUIRE(still.contains(moment));
        REQUIRE(still.begin >= first);
        REQUIRE(still.end <= to);
        const Progress now = progress_at(to, moment.ticks, laws);
        for (std::int32_t ticks = still.begin.ticks; ticks < still.end.ticks; ++ticks)
            REQUIRE(are_equal(progress_at(to, ticks, laws), now));
    }
}

TEST_CASE("steps over the longest stretch are still where it is certain")
{
    const Time to{(1 << 30) - 1};
    const VelocityLaw law = VelocityLaw::in_steps(65535);
    for (const std::int32_t ticks : {first.ticks, 5'000'000, 1'073'000'000, to.ticks - 1}) {
        const Still still = between(to, Time{ticks}, law);
        CHECK(still.contains(Time{ticks}));
        CHECK(are_equal(progress_at(to, still.begin.ticks, {law, law}), progress_at(to, ticks, {law, law})));
        CHECK(
            are_equal(progress_at(to, still.end.ticks - 1, {law, law}), progress_at(to, ticks, {law, law})));
    }
}

}
