#include "host/picture/film.hpp"

#include "core/time/time.hpp"

#include <doctest/doctest.h>

#include <cmath>

namespace kfast::test {
namespace {

constexpr std::int64_t frame = Time::ticks_per_frame;

void check_exact(std::int64_t ticks, std::uint32_t rate, int numerator, int denominator)
{
    const FilmDelay delay = film_delay(ticks, rate);
    CAPTURE(ticks);
    CAPTURE(rate);
    CHECK(delay.is_exact);
    CHECK(int{delay.numerator} == numerator);
    CHECK(int{delay.denominator} == denominator);
}

TEST_CASE("delays of whole frames are exact fractions in lowest terms")
{
    check_exact(frame, 30000, 1, 30);
    check_exact(45 * frame, 30000, 3, 2);
    check_exact(frame, 29970, 100, 2997);
    check_exact(frame, 23976, 125, 2997);
    check_exact(frame, 1'000'000, 1, 1000);
    check_exact(frame / 2, 30000, 1, 60);
    check_exact(frame, 1, 1000, 1);
}

TEST_CASE("a delay that no fraction of 16 bits tells is near")
{
    for (const std::int64_t ticks : {frame * 656, frame + 1, frame * 77 + 13}) {
        const FilmDelay delay = film_delay(ticks, 29970);
        const double wanted = static_cast<double>(ticks) * 1000 / (29970.0 * 1024);
        CHECK_FALSE(delay.is_exact);
        CHECK(std::abs(delay.numerator / static_cast<double>(delay.denominator) - wanted) < 1e-4);
    }
}

TEST_CASE("delays end at 65535 seconds")
{
    const FilmDelay delay = film_delay(70'000 * frame, 1000);
    CHECK_FALSE(delay.is_exact);
    CHECK(delay.numerator == 65535);
    CHECK(delay.denominator == 1);
    CHECK(film_delay(1, 1'000'000).numerator == 0); // less than 1/65535 s
}

}
}
