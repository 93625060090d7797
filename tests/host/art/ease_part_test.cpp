#include "host/art/animation/ease.hpp"

#include "tests/rounds.hpp"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <random>

namespace kfast::test {
namespace {

using art::Ease;
using art::EaseKind;

double by_parts(const std::vector<art::EasePart>& parts, double time)
{
    const auto part = std::ranges::find_if(parts, [&](const auto& one) { return time <= one.to; });
    const double share = (time - part->from) / (part->to - part->from);
    return part->way_from + share_of_way(part->ease, share) * (part->way_to - part->way_from);
}

struct Random {
    std::mt19937 engine{2};
    double operator()(double low, double high)
    {
        return std::uniform_real_distribution<double>{low, high}(engine);
    }
    Ease ease() { return {EaseKind::cubic, (*this)(0, 1), (*this)(-2, 3), (*this)(0, 1), (*this)(-2, 3)}; }
};

}

TEST_CASE("the parts of an ease go as the ease does")
{
    Random random;
    double max = 0;
    for (int round = 0; round < rounds(4000); ++round) {
        const Ease ease = random.ease();
        double from = random(0, 1);
        double to = random(0, 1);
        if (from > to)
            std::swap(from, to);
        if (to - from < 0.001)
            continue;
        const auto parts = art::ease_parts(ease, from, to);
        CHECK(parts.front().from == from);
        CHECK(parts.back().to == to);
        for (std::size_t i = 0; i < parts.size(); ++i) {
            CHECK(parts[i].from < parts[i].to);
            CHECK((i == 0 || parts[i - 1].to == parts[i].from));
            CHECK(std::abs(parts[i].ease.y1 - 0.5) <= art::highest_y + 1e-6);
            CHECK(std::abs(parts[i].ease.y2 - 0.5) <= art::highest_y + 1e-6);
            CHECK((parts[i].ease.x1 >= 0 && parts[i].ease.x1 <= 1));
            CHECK((parts[i].ease.x2 >= 0 && parts[i].ease.x2 <= 1));
        }
        for (int i = 0; i <= 50; ++i) {
            const double time = i < 50 ? from + (to - from) * i / 50 : to;
            max = std::max(max, std::abs(by_parts(parts, time) - share_of_way(ease, time)));
        }
    }
    CHECK(max < 1e-4);
}

TEST_CASE("a part whose ends are level still goes up between them")
{
    const Ease there_and_back{EaseKind::cubic, 0.3, 3, 0.7, -2};
    const auto time_of = [&](double way) {
        double low = 0.3;
        double high = 0.6;
        for (int i = 0; i < 60; ++i)
            ((share_of_way(there_and_back, (low + high) / 2) > way) ? low : high) = (low + high) / 2;
        return low;
    };
    const double from = 0.1;
    const double to = time_of(share_of_way(there_and_back, from));
    REQUIRE(std::abs(share_of_way(there_and_back, to) - share_of_way(there_and_back, from)) < 1e-9);
    const auto parts = art::ease_parts(there_and_back, from, to);
    CHECK(parts.size() > 1);
    for (int i = 0; i <= 50; ++i) {
        const double time = i < 50 ? from + (to - from) * i / 50 : to;
        CHECK(by_parts(parts, time) == doctest::Approx(share_of_way(there_and_back, time)).epsilon(1e-5));
    }
}

TEST_CASE("parts of straight and held ways are what they are")
{
    const auto line = art::ease_parts({}, 0.25, 0.5);
    REQUIRE(line.size() == 1);
    CHECK(line[0].way_from == 0.25);
    CHECK(line[0].way_to == 0.5);
    CHECK(line[0].ease.kind == EaseKind::linear);
    const Ease hold{EaseKind::hold};
    CHECK(art::ease_parts(hold, 0.25, 0.5)[0].way_to == 0);
    CHECK(art::ease_parts(hold, 0.25, 1)[0].way_to == 1);
    CHECK(art::ease_parts(hold, 0.25, 1)[0].ease.kind == EaseKind::hold);
}

TEST_CASE("a whole ease is one part, however far it swings")
{
    const Ease far{EaseKind::cubic, 0.3, 30, 0.7, -20};
    const auto parts = art::ease_parts(far, 0, 1);
    REQUIRE(parts.size() == 1);
    CHECK(parts[0].ease == far);
}

TEST_CASE("a reversed ease runs backwards")
{
    Random random;
    for (int round = 0; round < 200; ++round) {
        const Ease ease = random.ease();
        const double time = random(0, 1);
        CHECK(share_of_way(reversed(ease), time) ==
              doctest::Approx(1 - share_of_way(ease, 1 - time)).epsilon(1e-6));
    }
    CHECK(reversed(Ease{}) == Ease{});
}

}
